        include "span.i"

; span_affine_addx_wrap - span_affine_addx if v wraps more than once in a span
;
; like:    span_affine_addx
; formats: u, v 8.16, both wrap at 256 any number of times; 8-bit texels, pixels

; S, Q and P in three registers: P is stepped as a word, so V's overflow is lost
; instead of entering u. One addition more than the chain: it costs 2 cycles with
; the map in fast RAM and none in chip RAM, where the loop waits for the bus anyway.

        span span_affine_addx_wrap
        apart_open
        lea     .pixels_end-14(pc),a3
        span_line d0,d1
        apart_start
        span_rounds 4
        span_enter 2,4
.pixels rept    16
        pixel_apart
        endr
        span_close (sp)
