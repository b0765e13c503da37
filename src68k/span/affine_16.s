        include "wide.i"

; span_affine_16 - span_affine_addx with 16-bit texels and pixels
;
; like:    span_affine_addx
; formats: as span_affine_addx, with 16-bit texels and pixels; the map is a MAP_PAGE of such
;          texels, at any multiple of 2; plan->row is 2 EDGE_BIAS bytes before its
;          first pixel

; The index is a signed word. Forming a longword address, as for 8-bit texels, would need a page
; of 65,536 texels at a multiple of its size, and a shift of U and V.

        span span_affine_16
        wide_chain 2
