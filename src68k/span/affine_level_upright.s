        include "upright.i"

; span_affine_level_upright - span_affine_level for columns of the frame
;
; like:    span_affine_upright
; error:   as span_affine_level
        span span_affine_level_upright
        upright_open
        upright_line
        move.l  (a2)+,d2
        move.l  (a2),d5
        chain_steps
        span_rounds_out 3
        add.l   a4,d1
        span_enter_out 2,4
.pixels rept    8
        texel_next d2,d3
        draw_upright
        endr
        upright_close
