        include "routine.i"
        include "layout.i"
        include "span.i"

;==============================================================================
; span_tiled - draws a scanline table from a 256x256 map in tiles of 8x8
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start0 = uu, start1 = UU, start2 = VVvv), the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels; the map at a
;          multiple of 65,536, texel (u, v) at 2048 (u/8) + 8 v + u%8
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v + n dvdx))
; cost:    bench row tiled
;==============================================================================
; The circular carry chain of span_affine_addx, its integers where the index has
; them (T: tile column, U: texel in the tile, one letter a bit):
;       B  uuuuuuuuuuuuuuuu ooooo VVVVVVVV vvv
;       A  vvvvvvvvvvvvv000 TTTTT -------- UUU
; Eight ones in A's step take a carry from UUU over the gap to TTTTT; the gap and
; T's overflow are cleared in every step. V's overflows collect in o, 8 at most
; until it is cleared. A's v runs one step ahead, so that its carry is ready.

pixel   macro
        move.w  d0,d4
        and.w   d5,d4
        or.w    d1,d4                   ; mm, TTTTTVVVVVVVVUUU
        movea.l d4,a2
        addx.l  d2,d0
        addx.l  d3,d1
        and.l   d6,d1
        move.b  (a2),(a1)+
        endm

; Packs u (\1 = uu:UU) and v (\2 = VVvv) into B (\1) and A (\2). \3: scratch, its
; lower word; \4 = A's mask.
pack_tiled macro
        move.w  \1,\3
        lsl.w   #8,\3
        move.b  \1,\3                   ; TTTTTUUU twice
        ror.l   #8,\2
        ror.l   #5,\2                   ; v's lower 13 bits on top, VVVVVVVVvvv below
        move.w  \2,\1
        and.w   #$7ff,\1
        move.w  \3,\2
        and.l   \4,\2
        endm

        routine span_tiled,a0
        span_open
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d3
        span_table
        move.l  #$fff8f807,d6
        swap    d2
        pack_tiled d2,d3,d4,d6
        move.l  d3,d0
        clr.w   d0
        movea.l d0,a4                   ; v's lower 13 bits
        move.l  #$000707f8,d5           ; what A's mask is not
        or.w    d5,d3
        lea     .pixels_end-4-16(pc),a3
        span_line d0,d1
        span_rounds 3
        lea     (a3,d6.w*8),a2
        lea     (a2,d6.w*8),a2
        move.l  d5,d6
        not.l   d6
        pack_tiled d0,d1,d4,d6
        add.l   a4,d1
        jmp     (a2)
.pixels rept    8
        pixel
        endr
        and.w   #$7ff,d0
        span_close (sp)
