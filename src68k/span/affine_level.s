        include "span.i"

; span_affine_level - span_affine_scanline by the chain of two registers
;
; like:    span_affine_scanline
; error:   u is a unit more where v has wrapped upwards, and less where downwards, for each time

        span span_affine_level
        level_open d4
        lea     .pixels_end-12(pc),a3
        span_line d0,d1
        level_steps
        span_rounds 4
        add.l   a4,d1
        span_enter 4
.pixels rept    16
        pixel_chain
        endr
.pixels_end
        level_next
