        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "reciprocal.i"

;==============================================================================
; span_reciprocal_8 - draws lines with perspective, pieces of 8 pixels, by a table
;
; in:      a0  reciprocal_span*  the lines, the frame, the map, the table
; reads:   as span_reciprocal_16
; writes:  the pixels of the lines, nothing else
; formats: as span_reciprocal_16
; error:   as span_reciprocal_16
; cost:    bench row persp_every8
;==============================================================================
        routine span_reciprocal_8,a0
        reciprocal_pieces 3
