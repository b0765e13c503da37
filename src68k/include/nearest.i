; Quotients rounded to the nearest.

        include "routine.i"

; \2 = \1:\2 / d4, to the nearest, halves up. d6 = 0, d7 = d4 / 2.
nearest macro
        add.l   d7,\2
        addx.l  d6,\1
        divs.l  d4,\1:\2                ; towards zero
        tst.l   \1
        minus   <subq.l #1,\2>
        endm
