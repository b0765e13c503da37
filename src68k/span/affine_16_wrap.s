        include "wide.i"

; span_affine_16_wrap - span_affine_addx_wrap with 16-bit texels and pixels
;
; like:    span_affine_addx_wrap
; formats: as span_affine_addx_wrap and span_affine_16

        span span_affine_16_wrap
        wide_apart 2
