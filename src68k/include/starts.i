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
