        include "dither.i"

; span_dithered_32 - span_dithered with 32-bit texels and pixels
;
; like:    span_dithered
; formats: as span_dithered, with the 32-bit texels and pixels of span_affine_32

        span span_dithered_32
        dither_chain_open
        movea.l d4,a3
        dither_chain_lines draw_wide,4,*4,pc
