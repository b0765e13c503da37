        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_affine_short - span_affine_addx for lines of 16 pixels at most
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_addx
; error:   none, as span_affine_addx
; cost:    bench row affine_short
;==============================================================================

        routine span_affine_short,a0
        movem.l d2-d7/a2/a4/a6,-(sp)
        move.l  span_plan_map(a0),d4
        move.l  span_plan_pitch(a0),d5
        movea.l span_plan_row(a0),a6
        move.l  span_plan_count(a0),d7
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d6
        movea.l span_plan_lines(a0),a0
        moveq   #0,d3
        move.b  d6,d3
        ror.l   #8,d3
        movea.l d3,a4
        lsr.l   #8,d6
        swap    d2
        move.b  d2,d3
        clr.w   d2
        ext.l   d6
        bpl.s   .packed
        tst.l   d2
        bne.s   .packed
        subq.b  #1,d3
.packed add.l   d6,d2
        bra     .line
.pixels rept    16
        pixel_chain
        endr
.pixels_end
.next   adda.l  d5,a6
.line   subq.w  #1,d7
        bmi.s   .done
        move.l  (a0)+,d0
        lea     (a6,d0.w),a1
        move.w  (a0)+,d6
        sub.w   d0,d6
        bmi.s   .empty
        neg.w   d6
        move.w  (a0)+,d0
        move.l  (a0)+,d1
        lea     .pixels_end-12(pc,d6.w*4),a2
        add.l   a4,d1
        jmp     (a2,d6.w*8)
.empty  addq.l  #6,a0
        bra.s   .next
.done   movem.l (sp)+,d2-d7/a2/a4/a6
        rts
