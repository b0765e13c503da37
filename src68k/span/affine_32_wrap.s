        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_affine_32_wrap - span_affine_addx_wrap with 32-bit texels and pixels
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_addx_wrap and span_affine_32
; error:   none, as span_affine_addx_wrap
; cost:    bench row affine_32_wrap
;==============================================================================

        routine span_affine_32_wrap,a0
        wide_apart 4
