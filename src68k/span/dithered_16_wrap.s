        include "dither.i"

; span_dithered_16_wrap - span_dithered_wrap with 16-bit texels and pixels
;
; like:    span_dithered_wrap
; formats: as span_dithered_wrap and span_dithered_16

        span span_dithered_16_wrap
        dither_apart_open
        movea.l d4,a3
        dither_apart_lines 2,1,draw_wide,2,*2
