        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"
        include "dither.i"

;==============================================================================
; span_dithered_wrap - span_dithered if v wraps in a span
;
; in:      a0  span_plan*  the table, the frame, the map, the steps, odd
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_dithered, but v wraps any number of times
; error:   none, as span_dithered
; cost:    bench row dithered_wrap
;==============================================================================
; All data registers are taken, so the loop ends by the pixel's address.

        routine span_dithered_wrap,a0
        dither_apart_open
        dither_apart_lines 1,0,draw
