        include "routine.i"

; mul_div - a * b / c, rounded to the nearest integer, through 64 bits
;
; in:      d0  int32  a
;          d1  int32  b
;          a0  int32  c, above 0
; out:     d0  int32  floor((a * b + floor(c / 2)) / c)
; formats: any; with b = 65536 the quotient a / c in 16.16
; error:   half a unit; the quotient must fit 32 bits
; cost:    110 cycles with the cache warm, plus call and arguments
        routine mul_div,d0,d1,a0
        movea.l d2,a1
        muls.l  d1,d1:d0
        move.l  a0,d2
        lsr.l   #1,d2
        add.l   d2,d0
        moveq   #0,d2
        addx.l  d2,d1
        move.l  a0,d2
        divs.l  d2,d1:d0                ; towards zero: remainder of the sign of a * b
        tst.l   d1
        minus   <subq.l #1,d0>
        move.l  a1,d2
        rts
