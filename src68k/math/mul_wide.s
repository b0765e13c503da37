        include "routine.i"

; mul_wide - a gradient times an offset
;
; in:      a0  const number64*  gradient, 48.16 signed
;          d0  fix16      offset, 16.16
; out:     d0  int32      (gradient * offset + 2^31) / 2^32 rounded down, its low 32 bits
; formats: the product in units, 32.0
; error:   half a unit
; cost:    110 cycles, in chip RAM 130; with the cache warm, plus call and arguments
        routine mul_wide,a0,d0
        movem.l d2-d3,-(sp)
        move.l  d0,d3
        move.l  number64_lo(a0),d2
        mulu.l  d2,d1:d3
        tst.l   d0
        bpl.s   .unsigned
        sub.l   d2,d1                   ; the offset was taken as 2^32 too large
.unsigned
        muls.l  number64_hi(a0),d0
        add.l   d1,d0
        add.l   d3,d3                   ; half a unit
        moveq   #0,d3
        addx.l  d3,d0
        movem.l (sp)+,d2-d3
        rts
