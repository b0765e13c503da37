; Numbers of 64 bits (struct number64).

        include "routine.i"

; Adds \2(\3) to the number \1 on the stack. Uses d0-d1.
next    macro
        move.l  \2+number64_lo(\3),d1
        add.l   d1,\1+number64_lo(sp)
        move.l  \1(sp),d0
        move.l  \2(\3),d1
        addx.l  d1,d0
        move.l  d0,\1(sp)
        endm
