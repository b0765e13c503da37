        include "routine.i"
        include "layout.i"

;==============================================================================
; wide_mul - a gradient times an offset: how much a plane rises over it
;
; in:      a0  wide*  gradient, 32.32 signed
;          d0  int32  offset, 16.16 signed
; out:     d0  int32  floor(gradient * offset + 1/2 unit), 16.16 modulo 2^32
; trashes: d0-d1/a0-a1
; reads:   the gradient
; writes:  -
; formats: 32.32 * 16.16 -> 16.16
; error:   half a unit of 1/65536
; cost:    about 110 cycles
;==============================================================================
        routine wide_mul,a0,d0
        movem.l d2-d4,-(sp)
        move.l  wide_lo(a0),d1
        move.l  d0,d2
        mulu.l  d1,d3:d2                ; lo * offset, both taken as unsigned
        tst.l   d0
        bpl.s   .positive
        sub.l   d1,d3                   ; offset was 2^32 too large
.positive
        add.l   #$80000000,d2           ; round
        moveq   #0,d4
        addx.l  d4,d3
        muls.l  wide_hi(a0),d0
        add.l   d3,d0
        movem.l (sp)+,d2-d4
        rts
