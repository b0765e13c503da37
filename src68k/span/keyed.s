        include "keyed.i"

; span_keyed - span_affine_addx without the pixels whose texel is 0
;
; like:    span_affine_addx
; writes:  the pixels of the lines whose texel is not 0, nothing else
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v + n dvdx)), or what was there

        span span_keyed
        chain_open
        lea     .pixels_end-16(pc),a3
        span_line d0,d1
        span_rounds 3
        add.l   a4,d1
        span_enter 8
        keyed_round texel_next,d2,d3
        span_close d5,0
        keyed_passes
