        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_affine_addx_wrap - span_affine_addx if v wraps more than once in a span
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.16, both wrap at 256 any number of times; 8-bit texels, pixels
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v + n dvdx))
; cost:    bench row affine_addx_wrap
;==============================================================================
; S, Q and P in three registers: P is stepped as a word, so V's overflow is lost
; instead of entering u. One addition more than the chain: it costs 2 cycles with
; the map in fast RAM and none in chip RAM, where the loop waits for the bus anyway.

        routine span_affine_addx_wrap,a0
        apart_open
        lea     .pixels_end-14(pc),a3
        span_line d0,d1
        apart_start
        span_rounds 4
        span_enter_14
.pixels rept    16
        pixel_apart
        endr
        span_close (sp)
