        include "routine.i"

; mul_shift - a * b / 2^bits, rounded down
;
; in:      d0  int32  a
;          d1  int32  b
;          a0  int32  bits, 1 to 31
; out:     d0  int32  floor(a * b / 2^bits), its low 32 bits
; formats: any
; error:   less than a unit too low
; cost:    60 cycles with the cache warm, plus call and arguments
        routine mul_shift,d0,d1,a0
        movea.l d2,a1
        muls.l  d0,d0:d1
        move.l  a0,d2
        lsr.l   d2,d1
        neg.l   d2
        add.l   #32,d2
        lsl.l   d2,d0
        or.l    d1,d0
        move.l  a1,d2
        rts
