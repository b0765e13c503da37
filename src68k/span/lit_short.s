        include "short.i"

; span_lit_short - span_lit for short lines
;
; like:    span_lit
; formats: as span_lit; a line has SHORT_LIT pixels at most
; cost:    bench row affine_lit_short

        span span_lit_short
        short_open d2,d5
        chain_steps
        move.l  span_plan_light(a0),d5  ; lll0
        movea.l span_plan_lines(a0),a0
        bra     .line
        rept    SHORT_LIT
        texel_next d2,d3
        draw_lit d5
        endr
        short_line
        move.l  (a0)+,d1
        lea     .pixels_end-16(pc,d6.w*8),a2
        add.l   a4,d1
        jmp     (a2,d6.w*8)
        short_close
