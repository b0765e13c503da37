; Where the eye is beside the planes of faces and of trees.

        include "routine.i"

; d2 = normal * eye, rounded down to 16.16. The normal, 2.30, is in the struct \2 at \1; d5-d7 the eye, 16.16. Uses
; d0-d1/d3.
eye_along macro
        move.l  d5,d0
        muls.l  \2_x(\1),d1:d0
        move.l  d0,d3
        move.l  d1,d2
        move.l  d6,d0
        muls.l  \2_y(\1),d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        move.l  d7,d0
        muls.l  \2_z(\1),d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        add.l   d3,d3                   ; 46 fraction bits -> 48, the upper longword's 16
        addx.l  d2,d2
        add.l   d3,d3
        addx.l  d2,d2
        endm
