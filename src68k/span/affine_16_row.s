        include "wide.i"

; span_affine_16_row - span_affine_row with 16-bit texels and pixels
;
; like:    span_affine_row
; formats: as span_affine_row and span_affine_16

        span span_affine_16_row
        wide_row 2
