        include "dither.i"

; span_dithered_wrap - span_dithered if v wraps in a span
;
; like:    span_dithered
; formats: as span_dithered, but v wraps any number of times

; All data registers are taken, so the loop ends by the pixel's address.

        span span_dithered_wrap
        dither_apart_open
        dither_apart_lines 1,0,draw
