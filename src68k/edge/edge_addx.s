        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "slope.i"

        xref    edge_right

;==============================================================================
; edge_addx - fills a scanline table: swapped x and packed u, v, by add and addx
;
; in:      a0  edge_plan*  both sides, their edges, the gradients
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its edges
; writes:  plan->lines[0 .. lines of one side - 1]
; formats: x 16.16 with EDGE_BIAS, |x| < 16,384; left = ceil(x);
;          start0 = uuVv, start1 = v--U at the centre of the first pixel
; error:   none: x = x0 + n slope, u = u0 + n dudy + pixels dudx, all modulo 2^32
; cost:    bench row edge_addx
;==============================================================================
; u and v move along the left edge with the pixel they belong to: a line further
; and k or k+1 pixels to the right, which the carry of x tells. So they stay on
; the plane without a multiplication a line.

        routine edge_addx,a0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l a0,a6
        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_left(a6),a5
        move.l  edge_plan_lefts(a6),-(sp)

.left_edge
        move.l  edge_lines(a5),d0
        lsl.l   #2,d0
        lea     (a0,d0.l*2),a4
        adda.l  d0,a4                   ; end of these lines: 12 bytes each
        move.l  edge_slope(a5),d0
        swapped_slope d0,d1
        movea.l d0,a1                   ; slope, ff:ii
        move.l  edge_plan_dudx(a6),d0
        move.l  d0,d2
        muls.l  d1,d0
        add.l   edge_plan_dudy(a6),d0
        move.l  edge_plan_dvdx(a6),d3
        move.l  d3,d5
        muls.l  d1,d5
        add.l   edge_plan_dvdy(a6),d5
        pack_uv d0,d5,d4                ; a line and k pixels
        movea.l d0,a2
        pack_uv d2,d3,d6                ; one pixel
        movea.l d2,a3
        move.w  d3,d7
        move.l  edge_u(a5),d1
        move.l  edge_v(a5),d3
        pack_uv d1,d3,d2
        move.l  edge_x(a5),d0
        add.l   #$ffff,d0               ; its floor is x's ceil
        swap    d0                      ; xx:XX

        ; d0 x  d1 S  d2 Q  d3 P   d4 Q and d5 P: line   d6 Q and d7 P: pixel
        ; a1 slope  a2 S: line  a3 S: pixel  a0 table  a4 its end
.left_line
        addq.l  #2,a0
        move.w  d0,(a0)+
        move.w  d3,d1                   ; uuVv
        move.l  d1,(a0)+
        move.l  d2,(a0)+
        add.l   a1,d0
        bcs.s   .pixel_more
        add.l   a2,d1
        addx.l  d4,d2
        addx.w  d5,d3
        cmpa.l  a4,a0
        bne.s   .left_line
        bra.s   .left_next
.pixel_more
        addq.w  #1,d0
        add.l   a2,d1
        addx.l  d4,d2
        addx.w  d5,d3
        add.l   a3,d1
        addx.l  d6,d2
        addx.w  d7,d3
        cmpa.l  a4,a0
        bne.s   .left_line
.left_next
        lea     edge_sizeof(a5),a5
        subq.l  #1,(sp)
        bne     .left_edge
        addq.l  #4,sp
        jsr     edge_right
        movem.l (sp)+,d2-d7/a2-a6
        rts
