; u and v where left edges begin.

        include "routine.i"

; Finds the step of \1, u or v, along the edge a1 on the plane of the texturing a0; d4 = the edge's
; whole pixels a line, mostly 0 or -1. Uses d0-d1/d6.
start_step macro
        move.l  texturing_d\1dx(a0),d0
        move.l  texturing_d\1dy(a0),d1
        tst.l   d4
        beq.s   .upright\@
        move.l  d4,d6
        addq.l  #1,d6
        beq.s   .back\@
        move.l  d0,d6
        muls.l  d4,d6
        add.l   d6,d1
        bra.s   .upright\@
.back\@ sub.l   d0,d1
.upright\@
        move.l  d1,edge_d\1(a1)
        endm

; Finds \1, u or v, and its step where the edge a1 begins: d2, d3 = its distance from pixel (i, j),
; d4 = its whole pixels a line. Uses d0-d1/d5-d6.
start   macro
        start_step \1
        move.l  texturing_d\1dy(a0),d5
        muls.l  d2,d0
        muls.l  d3,d5
        add.l   d5,d0
        add.l   texturing_\1(a0),d0
        move.l  d0,edge_\1(a1)
        endm

; The same for u and v. Uses d0-d6.
start_edge macro
        move.l  edge_x(a1),d2
        sub.l   #EDGE_BIAS,d2
        sub.l   texturing_i(a0),d2
        move.l  edge_top(a1),d3
        sub.l   texturing_j(a0),d3
        move.l  edge_whole(a1),d4
        start   u
        start   v
        endm
