        include "routine.i"
        include "layout.i"
        include "slope.i"

        xref    edge_right

;==============================================================================
; edge_flat - fills a scanline table without u and v: all a flat polygon needs
;
; in:      a0  edge_plan*  both sides and their edges; gradients are not read
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its edges
; writes:  left and count of plan->lines[0 .. lines of one side - 1]
; formats: x 16.16 with EDGE_BIAS, |x| < 16,384; left = ceil(x)
; error:   none: x = x0 + n slope
; cost:    bench row edge_flat
;==============================================================================
        routine edge_flat,a0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l a0,a6
        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_left(a6),a5
        move.l  edge_plan_lefts(a6),d4
        moveq   #0,d3
        moveq   #scanline_sizeof,d5
.edge   move.l  edge_lines(a5),d0
        lsl.l   #2,d0
        lea     (a0,d0.l*2),a4
        adda.l  d0,a4
        move.l  edge_slope(a5),d2
        swapped_slope d2,d1
        move.l  edge_x(a5),d0
        add.l   #$ffff,d0
        swap    d0                      ; xx:XX
.line   move.w  d0,scanline_left(a0)
        add.l   d2,d0
        addx.w  d3,d0
        adda.l  d5,a0
        cmpa.l  a4,a0
        bne.s   .line
        lea     edge_sizeof(a5),a5
        subq.l  #1,d4
        bne.s   .edge
        jsr     edge_right
        movem.l (sp)+,d2-d7/a2-a6
        rts
