        include "short.i"

; span_affine_short - span_affine_addx for short lines
;
; like:    span_affine_addx
; formats: as span_affine_addx; a line has SHORT_AFFINE pixels at most

        span span_affine_short
        short_open d2,d5
        movea.l span_plan_lines(a0),a0
        chain_steps
        bra     .line
        rept    SHORT_AFFINE
        pixel_chain
        endr
        short_line
        move.l  (a0)+,d1
        lea     .pixels_end-12(pc,d6.w*4),a2
        add.l   a4,d1
        jmp     (a2,d6.w*8)
        short_close
