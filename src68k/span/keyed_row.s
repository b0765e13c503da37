        include "keyed.i"

; span_keyed_row - span_keyed if v's step is 0: billboards, upright pictures
;
; like:    span_affine_row
; writes:  the pixels of the lines whose texel is not 0, nothing else
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v)), or what was there

        span span_keyed_row
        alone_open dudx
        pack_alone d2,d5,a4
        move.l  (sp),d3
        lea     .pixels_end-12(pc),a3
        span_line d0,d1
        span_rounds 3
        move.w  d0,d4                   ; mmVv
        move.b  d1,d5
        move.w  d5,d0                   ; uu-U
        add.l   a4,d0
        span_enter 4
        keyed_round row_next,d2
        span_close d3
        keyed_passes
