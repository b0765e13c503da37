        include "wide.i"

; span_affine_32_level - span_affine_32_scanline by the chain of two registers
;
; like:    span_affine_32_scanline
; error:   as span_affine_level

        span span_affine_32_level
        wide_level 4
