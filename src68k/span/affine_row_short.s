        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "short.i"

;==============================================================================
; span_affine_row_short - span_affine_row for lines of 24 pixels at most
;
; in:      a0  span_plan*  the table, the frame, the map, the step dudx
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_row; no line is longer than SHORT_AFFINE_ROW
; error:   none, as span_affine_row
; cost:    bench row affine_row_short
;==============================================================================

pixel   macro
        move.b  d0,d4                   ; mmVU
        addx.l  d2,d0
        draw
        endm

        routine span_affine_row_short,a0
        short_open
        move.l  span_plan_dudx(a0),d2
        movea.l span_plan_lines(a0),a0
        pack_alone d2,d5,a4
        bra     .line
        rept    SHORT_AFFINE_ROW
        pixel
        endr
        short_line d4                   ; mmVv
        move.l  (a0)+,d1
        move.b  d1,d5
        move.w  d5,d0                   ; uu-U
        add.l   a4,d0
        jmp     .pixels_end-8(pc,d6.w*8)
        short_close 4
