        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_affine_32 - span_affine_addx with 32-bit texels and pixels
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_addx, with 32-bit texels and pixels; the map is a MAP_PAGE of such
;          texels, at any multiple of 4; plan->row is 4 EDGE_BIAS bytes before its
;          first pixel
; error:   none, as span_affine_addx
; cost:    bench row affine_32
;==============================================================================

        routine span_affine_32,a0
        wide_chain 4
