        include "routine.i"
        include "layout.i"

;==============================================================================
; edge_swap - fills a scanline table by add and swap, for comparison
;
; in:      a0  edge_plan*  both sides, their edges, the gradients
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its edges
; writes:  plan->lines[0 .. lines of one side - 1]
; formats: x 16.16 with EDGE_BIAS, |x| < 16,384; left = ceil(x);
;          start0 = UUuu, start1 = VVvv at the centre of the first pixel
; error:   none: the same numbers as edge_addx
; cost:    bench row edge_swap
;==============================================================================
        routine edge_swap,a0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l a0,a6
        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_left(a6),a5
        move.l  edge_plan_lefts(a6),-(sp)

.left_edge
        move.l  edge_lines(a5),d0
        lsl.l   #2,d0
        lea     (a0,d0.l*2),a4
        adda.l  d0,a4
        move.l  edge_slope(a5),d3
        move.l  d3,d7
        swap    d7                      ; k: whole pixels a line
        move.w  d7,d0
        ext.l   d0
        movea.l edge_plan_dudx(a6),a1
        movea.l edge_plan_dvdx(a6),a2
        move.l  a1,d4
        muls.l  d0,d4
        add.l   edge_plan_dudy(a6),d4
        move.l  a2,d5
        muls.l  d0,d5
        add.l   edge_plan_dvdy(a6),d5
        move.l  edge_u(a5),d1
        move.l  edge_v(a5),d2
        move.l  edge_x(a5),d0
        add.l   #$ffff,d0
        move.l  d0,d6
        swap    d6

        ; d0 x  d1 u  d2 v  d3 slope  d4, d5 u, v: a line and k pixels
        ; d6 left  d7 k  a1, a2 u, v: a pixel
.left_line
        addq.l  #2,a0
        move.w  d6,(a0)+
        move.l  d1,(a0)+
        move.l  d2,(a0)+
        add.l   d4,d1
        add.l   d5,d2
        add.w   d7,d6                   ; left without the fraction's carry
        add.l   d3,d0
        swap    d0
        cmp.w   d0,d6
        beq.s   .no_carry
        move.w  d0,d6
        add.l   a1,d1
        add.l   a2,d2
.no_carry
        swap    d0
        cmpa.l  a4,a0
        bne.s   .left_line
        lea     edge_sizeof(a5),a5
        subq.l  #1,(sp)
        bne.s   .left_edge
        addq.l  #4,sp

        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_right(a6),a5
        move.l  edge_plan_rights(a6),d4
        moveq   #scanline_sizeof,d5
.right_edge
        move.l  edge_lines(a5),d0
        lsl.l   #2,d0
        lea     (a0,d0.l*2),a4
        adda.l  d0,a4
        move.l  edge_slope(a5),d2
        move.l  edge_x(a5),d0
        add.l   #$ffff,d0
.right_line
        move.l  d0,d1
        swap    d1
        sub.w   scanline_left(a0),d1
        move.w  d1,(a0)
        adda.l  d5,a0
        add.l   d2,d0
        cmpa.l  a4,a0
        bne.s   .right_line
        lea     edge_sizeof(a5),a5
        subq.l  #1,d4
        bne.s   .right_edge
        movem.l (sp)+,d2-d7/a2-a6
        rts
