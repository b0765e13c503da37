        include "span.i"

; span_tiled - draws a scanline table from a 256x256 map in tiles of 8x8
;
; like:    span_affine_swap
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels; the map at a
;          multiple of 65,536, texel (u, v) at 2048 (u/8) + 8 v + u%8
; error:   pixel n shows texel (floor(u + n dudx), floor((v2 + n dv2) / 32768)),
;          where v2 = floor(v / 2), dv2 = floor(dvdx / 2)

; The circular carry chain of span_affine_addx, its integers where the index has
; them (T: column of tiles, U: texel in its tile; one letter a bit):
;       B  uuuuuuuuuuuuuuuu ----- VVVVVVVV ---
;       A  vvvvvvvvvvvvvvv- TTTTT -------- UUU
; Ones in a step's inner gaps (A's eight, B's last three) pass a carry on; after
; each step all gaps are cleared, and so are overflows into them. A's v is one step
; ahead, so that its carry is ready when B needs it.

; Packs u (\1 = uu:UU) and v (\2 = VVvv) into B (\1) and A (\2), by their masks d5
; and d6. Uses d4's lower word.
pack_tiled macro
        move.w  \1,d4
        lsl.w   #8,d4
        move.b  \1,d4                   ; TTTTTUUU twice
        swap    \2                      ; vv:VV
        move.w  \2,\1
        lsl.w   #3,\1
        move.w  d4,\2
        and.l   d5,\1
        and.l   d6,\2
        endm

        span span_tiled
        span_open
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d3
        span_table
        move.l  #$ffff07f8,d5           ; what B keeps
        move.l  #$fffef807,d6           ; what A keeps
        swap    d2
        pack_tiled d2,d3
        move.l  d3,d0
        clr.w   d0
        movea.l d0,a4                   ; v's fraction
        addq.w  #7,d2
        or.w    d5,d3
        lea     .pixels_end-16(pc),a3
        span_line d0,d1
        move.w  d7,d6                   ; not span_rounds: d6's upper word must stay
        and.w   #7,d6
        neg.w   d6
        lsr.w   #3,d7
        lea     (a3,d6.w*8),a2
        lea     (a2,d6.w*8),a2
        move.w  #$f807,d6
        pack_tiled d0,d1
        add.l   a4,d1
        jmp     (a2)
.pixels rept    8
        move.w  d0,d4
        or.w    d1,d4                   ; mm, TTTTTVVVVVVVVUUU
        addx.l  d2,d0
        addx.l  d3,d1
        and.l   d6,d1
        and.l   d5,d0
        draw
        endr
        span_close (sp)
