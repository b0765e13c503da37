        include "dither.i"

; span_dithered_16 - span_dithered with 16-bit texels and pixels
;
; like:    span_dithered
; formats: as span_dithered, with the 16-bit texels and pixels of span_affine_16

        span span_dithered_16
        dither_chain_open
        movea.l d4,a3
        dither_chain_lines draw_wide,2,*2,pc
