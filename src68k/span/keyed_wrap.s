        include "keyed.i"

; span_keyed_wrap - span_keyed if v wraps more than once in a span
;
; like:    span_keyed
; formats: u, v 8.16, both wrap at 256 any number of times; 8-bit texels, pixels

        span span_keyed_wrap
        apart_open
        lea     .pixels_end-18(pc),a3
        span_line d0,d1
        apart_start
        span_rounds 3
        span_enter 8,2
        keyed_round texel_next_apart,d2,d3
        span_close (sp)
        keyed_passes
