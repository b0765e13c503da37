        include "routine.i"

; mesh_cut - the point where a border cuts an edge, all six values of a vertex
;
; in:      a0  const struct cut_plan*  part is 0 or more and less than whole
; reads:   the plan, both vertices
; writes:  *to
; formats: any; the ends' values differ by less than 2^31
; error:   half a unit, ties away from the inner end; never beyond the outer end
        routine mesh_cut,a0
        movem.l d2-d6/a2-a3,-(sp)
        move.l  cut_plan_part(a0),d2
        move.l  cut_plan_whole(a0),d3
        move.l  d3,d4
        lsr.l   #1,d4
        moveq   #0,d5
        movea.l cut_plan_inside(a0),a1
        movea.l cut_plan_outside(a0),a2
        movea.l cut_plan_to(a0),a0
        moveq   #vertex_sizeof/4-1,d6
.value  move.l  (a1)+,d0
        movea.l d0,a3
        sub.l   (a2)+,d0
        beq.s   .same
        bpl.s   .falls
        neg.l   d0
        mulu.l  d2,d1:d0
        add.l   d4,d0
        addx.l  d5,d1
        divu.l  d3,d1:d0
        adda.l  d0,a3
        bra.s   .same
.falls  mulu.l  d2,d1:d0
        add.l   d4,d0
        addx.l  d5,d1
        divu.l  d3,d1:d0
        suba.l  d0,a3
.same   move.l  a3,(a0)+
        dbra    d6,.value
        movem.l (sp)+,d2-d6/a2-a3
        rts
