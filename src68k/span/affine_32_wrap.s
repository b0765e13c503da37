        include "wide.i"

; span_affine_32_wrap - span_affine_addx_wrap with 32-bit texels and pixels
;
; like:    span_affine_addx_wrap
; formats: as span_affine_addx_wrap and span_affine_32

        span span_affine_32_wrap
        wide_apart 4
