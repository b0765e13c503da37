        include "wide.i"

; span_affine_32 - span_affine_addx with 32-bit texels and pixels
;
; like:    span_affine_addx
; formats: as span_affine_addx, with 32-bit texels and pixels; the map is a MAP_PAGE of such
;          texels, at any multiple of 4; plan->row is 4 EDGE_BIAS bytes before its
;          first pixel

        span span_affine_32
        wide_chain 4
