        include "routine.i"

; n64_tile_walked - coordinates of n64_walk relative to a tile without shifts
;
; like:    n64_tile
; cost:    bench row n64_tile_walked: of a line inside the tile; others take about 90 cycles more than by
;          n64_tile

; A line whose ends are inside an axis that clamps is inside it, if no coordinate wraps between them:
; a step is less than 1 + |the first step| away from 0.

        xref    n64_tile

        pass    n64_tile_walked
        movem.l d2-d4/a0/a2-a3,-(sp)
        lea     (a0,d0.l*4),a3
        bsr.s   .look
        addq.l  #2,a0
        addq.l  #2,a3
        lea     n64_axis_range_sizeof(a2),a2
        bsr.s   .look
        subq.l  #2,a0
        subq.l  #2,a3
        move.w  n64_axis_range_low(a2),d3
        move.w  n64_axis_range_low-n64_axis_range_sizeof(a2),d2
        move.w  d2,d4
        swap    d2
        clr.w   d2
        or.w    d3,d4
        bne.s   .pixels
        cmpa.l  a0,a1
        beq.s   .done
.pixels move.l  (a0)+,d0
        sub.w   d3,d0
        sub.l   d2,d0
        move.l  d0,(a1)+
        cmpa.l  a3,a0
        bne.s   .pixels
.done   movem.l (sp)+,d2-d4/a0/a2-a3
        rts

        ; does not return if a pixel's coordinate at a0 may be outside the axis a2
.look   tst.w   n64_axis_range_clamp(a2)
        beq.s   .inside
        move.w  (a0),d1
        move.w  n64_axis_range_low(a2),d2
        move.w  n64_axis_range_high(a2),d3
        cmp.w   d2,d1
        blt.s   .out
        cmp.w   d3,d1
        bge.s   .out
        move.w  -4(a3),d4
        cmp.w   d2,d4
        blt.s   .out
        cmp.w   d3,d4
        bge.s   .out
        move.w  4(a0),d4
        sub.w   d1,d4
        minus   <neg.w d4>
        addq.w  #1,d4
        mulu.w  d0,d4
        cmp.l   #$7fff,d4
        bhi.s   .out
.inside rts
.out    addq.l  #4,sp
        movem.l (sp)+,d2-d4/a0/a2-a3
        bra     n64_tile
