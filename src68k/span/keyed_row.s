        include "keyed.i"

; span_keyed_row - span_keyed if v's step is 0: billboards, upright pictures
;
; like:    span_affine_row
; writes:  the pixels of the lines whose texel is not 0, nothing else
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v)), or what was there

        span span_keyed_row
        keyed_row_line
        add.l   a4,d0
        span_enter 4
        keyed_round row_next,d2
        span_close d3
        keyed_passes
