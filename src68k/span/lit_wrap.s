        include "span.i"

; span_lit_wrap - span_lit if v wraps more than once in a span
;
; like:    span_lit
; formats: as span_affine_addx_wrap
; cost:    bench row affine_lit_wrap

        span span_lit_wrap
        apart_open light
        lea     .pixels_end-18(pc),a3
        span_line d0,d1
        apart_start
        span_rounds 3
        lea     (a3,d6.w*2),a2
        lea     (a2,d6.w*8),a2
        lea     (a2,d6.w*8),a2
        move.l  (sp),d6                 ; lll0
        jmp     (a2)
.pixels rept    8
        texel_next_apart d2,d3
        draw_lit d6
        endr
        span_close 4(sp),8
