        include "span.i"

; span_affine_column - span_affine_addx if u's step is 0: walls on their side
;
; in:      a0  span_plan*  the table, the frame, the map, the step dvdx
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: v 8.16, U 8 bits; both wrap at 256; 8-bit texels and pixels. dvdx is used
;          modulo 256, as -128 to 127.99: v moves 64,000 texels a line at most. dudx
;          is 0 modulo 256 and not read
; error:   none: pixel n shows texel (floor(u), floor(v + n dvdx))

; v alone, in a chain of one register: v-Vv, with the spare byte and the borrow of pack_alone.

        span span_affine_column
        alone_open dvdx
        moveq   #0,d3                   ; the spare byte of a line's start
        lsl.l   #8,d2
        asr.l   #8,d2                   ; -Vvv
        bmi.s   .falls
        ror.l   #8,d2                   ; v-Vv
        bra.s   .packed
.falls  ror.l   #8,d2
        move.l  #$ff0000,d3
        borrow  d2,1<<24,l
.packed ahead   d2,d5,a4,w              ; v-00
        lea     .pixels_end-10(pc),a3
        span_line d0,d1
        span_rounds 4
        move.b  d1,d5
        move.w  d0,d1                   ; v.Vv
        and.l   #$ff00ffff,d1
        or.l    d3,d1
        add.l   a4,d1
        span_enter 2
.pixels rept    16
        move.w  d1,d4                   ; mmVv
        move.b  d5,d4                   ; mmVU
        addx.l  d2,d1
        draw
        endr
        span_close (sp)
