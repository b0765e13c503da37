        include "routine.i"

; mul_round - product of two 16.16 numbers, rounded to the nearest
;
; like:    mul_fix
; out:     d0  int32  floor(a * b / 65536 + 1/2), its low 32 bits
; error:   half of 1/65536
; cost:    46 cycles with the cache warm, plus call and arguments
        routine mul_round,d0,d1
        muls.l  d0,d0:d1
        add.l   #$8000,d1
        bcc.s   .carried
        addq.l  #1,d0
.carried
        move.w  d0,d1                   ; hh:HH ll:LL -> HH:ll
        swap    d1
        move.l  d1,d0
        rts
