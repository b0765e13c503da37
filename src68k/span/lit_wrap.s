        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_lit_wrap - span_lit if v wraps more than once in a span
;
; in:      a0  span_plan*  the table, the frame, the map, the row, the steps
; reads:   as span_lit
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_addx_wrap
; error:   none, as span_lit
; cost:    bench row affine_lit_wrap
;==============================================================================

pixel   macro
        texel_next_apart
        draw_lit d6
        endm

        routine span_lit_wrap,a0
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
        pixel
        endr
        span_close 4(sp),8
