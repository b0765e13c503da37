        include "routine.i"

; mul_fix - product of two 16.16 numbers
;
; in:      d0  int32  a, 16.16
;          d1  int32  b, 16.16
; out:     d0  int32  floor(a * b / 65536), its low 32 bits
; trashes: d0-d1
; formats: 16.16 signed; the product must be within 16.16 to be meaningful
; error:   0 to 1/65536 too low (floor)
; cost:    40 cycles with the cache warm, plus call and arguments
        routine mul_fix,d0,d1
        muls.l  d0,d0:d1
        move.w  d0,d1                   ; hh:HH ll:LL -> HH:ll
        swap    d1
        move.l  d1,d0
        rts
