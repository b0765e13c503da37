        include "short.i"

; span_affine_short_wrap - span_affine_addx_wrap for short lines
;
; like:    span_affine_addx_wrap
; formats: as span_affine_addx_wrap; a line has SHORT_AFFINE_WRAP pixels at most

        span span_affine_short_wrap
        short_open d5,d2
        movea.l span_plan_lines(a0),a0
        apart_steps
        bra     .line
        rept    SHORT_AFFINE_WRAP
        pixel_apart
        endr
        short_line
        move.l  (a0)+,d1
        apart_start
        lea     .pixels_end-14(pc,d6.w*2),a2
        lea     (a2,d6.w*4),a2
        jmp     (a2,d6.w*8)
        short_close
