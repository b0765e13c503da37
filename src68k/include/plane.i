; Gradients of a plane through three points, from two vectors.

        include "routine.i"

; d7 = the divisor of the gradients, the upper 32 bits of the area d0:d7, which is not 0;
; d6 = the right shift that gives them, d5 = 32 - d6.
divisor macro
        bfffo   d0{0:32},d5
        moveq   #32,d6
        sub.l   d5,d6
        lsr.l   d6,d7
        lsl.l   d5,d0                   ; a shift by 32 gives 0
        or.l    d0,d7
        endm

; d1:d2 = (p1 q2 - p2 q1) / D in 32.32, cut towards zero; p, q: the fields \1, \2. D and the
; numerator have been shifted right by d6, which leaves 32 bits of D, in d7; d5 =
; 32 - d6. a2, a3: the two vectors from the first vertex.
gradient macro
        move.l  \1(a2),d1
        muls.l  \2(a3),d0:d1
        move.l  \1(a3),d3
        muls.l  \2(a2),d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        move.l  d0,d4                   ; sign
        minus   <neg.l d1>,<negx.l d0>
        move.l  d0,d3
        lsr.l   d6,d0
        lsr.l   d6,d1
        lsl.l   d5,d3
        or.l    d3,d1
        cmp.l   d7,d0
        blo.s   .fits\@
        moveq   #0,d3                   ; only its remainder counts, modulo 2^64
        divu.l  d7,d3:d0
        move.l  d3,d0
.fits\@ divu.l  d7,d0:d1
        moveq   #0,d2
        divu.l  d7,d0:d2
        tst.l   d4
        minus   <neg.l d2>,<negx.l d1>
        endm
