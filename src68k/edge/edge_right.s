        include "routine.i"
        include "layout.i"
        include "slope.i"

;==============================================================================
; edge_right - steps the right side and writes the counts; left must be there
;
; in:      a6  edge_plan*  the right side and its edges
; out:     -
; trashes: d0-d5/a0-a1/a4-a5
; reads:   the plan, its right edges, left of plan->lines
; writes:  count of plan->lines[0 .. lines of the side - 1]
; formats: x 16.16 with EDGE_BIAS; count = ceil(x) - left
; error:   none: x = x0 + n slope
; cost:    part of edge_addx and edge_flat, which call it
;==============================================================================
        routine edge_right
        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_right(a6),a5
        move.l  edge_plan_rights(a6),d4
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
.line   move.w  d0,d1
        sub.w   scanline_left(a0),d1
        move.w  d1,(a0)
        adda.l  d5,a0
        add.l   d2,d0
        addx.w  d3,d0
        cmpa.l  a4,a0
        bne.s   .line
        lea     edge_sizeof(a5),a5
        subq.l  #1,d4
        bne.s   .edge
        rts
