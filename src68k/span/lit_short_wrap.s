        include "short.i"

; span_lit_short_wrap - span_lit_wrap for short lines
;
; like:    span_lit_wrap
; formats: as span_lit_wrap; a line has SHORT_LIT_WRAP pixels at most
; cost:    bench row affine_lit_short_wrap

        span span_lit_short_wrap
        short_open d5,d2,light
        movea.l span_plan_lines(a0),a0
        apart_steps
        bra     .line
        rept    SHORT_LIT_WRAP
        texel_next_apart d2,d3
        draw_lit d6
        endr
        short_line
        move.l  (a0)+,d1
        apart_start
        lea     .pixels_end-18(pc,d6.w*2),a2
        lea     (a2,d6.w*8),a2
        lea     (a2,d6.w*8),a2
        move.l  (sp),d6                 ; lll0
        jmp     (a2)
        short_close 4
