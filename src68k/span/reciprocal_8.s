        include "reciprocal.i"

; span_reciprocal_8 - draws lines with perspective, pieces of 8 pixels, by a table
;
; like:    span_reciprocal_16
; cost:    bench row persp_every8
        routine span_reciprocal_8,a0
        reciprocal_pieces 3
