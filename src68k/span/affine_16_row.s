        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_affine_16_row - span_affine_row with 16-bit texels and pixels
;
; in:      a0  span_plan*  the table, the frame, the map, the step dudx
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_row and span_affine_16
; error:   none, as span_affine_row
; cost:    bench row affine_16_row
;==============================================================================

        routine span_affine_16_row,a0
        wide_row 2
