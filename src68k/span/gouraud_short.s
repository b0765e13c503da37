        include "short.i"

; span_gouraud_short - span_gouraud for short lines
;
; like:    span_gouraud
; formats: as span_gouraud; a line has SHORT_GOURAUD pixels at most

        span span_gouraud_short
        short_open
        move.l  span_plan_dudx(a0),d2
        movea.l span_plan_lines(a0),a0
        pack_alone d2,d5,a4
        bra     .line
        rept    SHORT_GOURAUD
        pixel_shade
        endr
        short_line_alone d1
        addq.l  #4,a0
        move.b  d1,d5
        move.w  d5,d0                   ; ss-S
        add.l   a4,d0
        jmp     .pixels_end-4(pc,d6.w*4)
        short_close
