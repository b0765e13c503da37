        include "routine.i"
        include "layout.i"

;==============================================================================
; cross - on which side of e1 the vector e2 lies, and how far
;
; in:      a0  vertex*  e1: second vertex minus the first
;          a1  vertex*  e2: third vertex minus the first
;          d0  wide*    where |x1 y2 - x2 y1| goes
; out:     d0  int32    sign of x1 y2 - x2 y1: -1, 0 or 1
; trashes: d0-d1/a0-a1
; reads:   x, y of e1 and e2
; writes:  *d0
; formats: x, y 16.16, each within 32 bits; the product 32.32, below 2^63
; error:   none
; cost:    about 160 cycles
;==============================================================================
        routine cross,a0,a1,d0
        movem.l d2-d5,-(sp)
        move.l  d0,d5
        move.l  vertex_x(a0),d1
        muls.l  vertex_y(a1),d0:d1
        move.l  vertex_y(a0),d3
        muls.l  vertex_x(a1),d2:d3
        movea.l d5,a0
        moveq   #0,d5
        sub.l   d3,d1
        subx.l  d2,d0
        bmi.s   .negative
        move.l  d0,d4
        or.l    d1,d4
        beq.s   .store
        moveq   #1,d5
        bra.s   .store
.negative
        moveq   #-1,d5
        neg.l   d1
        negx.l  d0
.store  move.l  d0,wide_hi(a0)
        move.l  d1,wide_lo(a0)
        move.l  d5,d0
        movem.l (sp)+,d2-d5
        rts
