        include "short.i"

; span_affine_row_short - span_affine_row for short lines
;
; like:    span_affine_row
; formats: as span_affine_row; a line has SHORT_AFFINE_ROW pixels at most

        span span_affine_row_short
        short_open d2
        movea.l span_plan_lines(a0),a0
        pack_alone d2,d5,a4
        bra     .line
        rept    SHORT_AFFINE_ROW
        pixel_row
        endr
        short_line_alone d4             ; mmVv
        move.l  (a0)+,d1
        move.b  d1,d5
        move.w  d5,d0                   ; uu-U
        add.l   a4,d0
        jmp     .pixels_end-8(pc,d6.w*8)
        short_close
