        include "dither.i"

; span_dithered_32_wrap - span_dithered_wrap with 32-bit texels and pixels
;
; like:    span_dithered_wrap
; formats: as span_dithered_wrap and span_dithered_32

        span span_dithered_32_wrap
        dither_apart_open
        movea.l d4,a3
        dither_apart_lines 4,2,draw_wide,4,*4
