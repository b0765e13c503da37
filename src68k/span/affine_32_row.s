        include "wide.i"

; span_affine_32_row - span_affine_row with 32-bit texels and pixels
;
; like:    span_affine_row
; formats: as span_affine_row and span_affine_32

        span span_affine_32_row
        wide_row 4
