        include "routine.i"
        include "layout.i"
        include "chain.i"

;==============================================================================
; span_affine_16_copy - span_affine_copy with 16-bit texels and pixels
;
; in:      a0  span_plan*  the table, the frame, the map
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_copy and span_affine_16
; error:   none, as span_affine_copy
; cost:    bench row affine_16_copy
;==============================================================================

        routine span_affine_16_copy,a0
        wide_copy 2
