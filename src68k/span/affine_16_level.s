        include "wide.i"

; span_affine_16_level - span_affine_16_scanline by the chain of two registers
;
; like:    span_affine_16_scanline
; error:   as span_affine_level

        span span_affine_16_level
        wide_level 2
