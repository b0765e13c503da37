        include "routine.i"
        include "layout.i"

; 64-bit e1.p * e2.q - e2.p * e1.q in d0:d1
cross   macro
        move.l  vertex_\1(a0),d1
        muls.l  vertex_\2(a1),d0:d1
        move.l  vertex_\1(a1),d3
        muls.l  vertex_\2(a0),d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        endm

; Makes d0:d1 positive; d4 is negated for each change of sign
absolute macro
        tst.l   d0
        bpl.s   .positive\@
        neg.l   d1
        negx.l  d0
        neg.l   d4
.positive\@
        endm

; Shifts d0:d1, not zero, left until bit 63 is one; d2 counts the shifts
normalise macro
        moveq   #0,d5
        tst.l   d0
        bne.s   .upper\@
        move.l  d1,d0
        moveq   #0,d1
        moveq   #32,d5
.upper\@
        bfffo   d0{0:32},d2
        move.l  d1,d3
        lsl.l   d2,d0
        lsl.l   d2,d1
        add.l   d2,d5
        neg.l   d2
        add.l   #32,d2
        lsr.l   d2,d3                   ; a shift by 32 gives 0
        or.l    d3,d0
        move.l  d5,d2
        endm

;==============================================================================
; gradients - how s and t change over the plane of three vertices
;
; in:      a0  vertex*  e1: second vertex minus the first
;          a1  vertex*  e2: third vertex minus the first
;          d0  plane*   where the gradients go
; out:     d0  int32    sign of D: 1, -1, or 0: the vertices are on one line and
;                       nothing is written
; trashes: d0-d1/a0-a1
; reads:   e1, e2
; writes:  plane: dsdx, dsdy, dtdx, dtdy
; formats: e1, e2 16.16, each difference within 32 bits; gradients 32.32
;          modulo 2^64. With D = x1 y2 - x2 y1:
;            dsdx = (s1 y2 - s2 y1) / D     dsdy = (x1 s2 - x2 s1) / D
; error:   |g| / 2^31 + 1/2^32 texels a pixel: the divisor keeps its upper 32
;          significant bits (cut: up to 1 in 2^31), the quotient is cut
; cost:    about 1,800 cycles
;==============================================================================
; Floating point in all but name: dividend and divisor are normalised, so no
; quotient can overflow and the smallest sliver keeps 31 significant bits.

        routine gradients,a0,a1,d0
        movem.l d2-d7/a2,-(sp)
        movea.l d0,a2
        cross   x,y
        move.l  d0,d2
        or.l    d1,d2
        beq     .line
        moveq   #1,d4
        absolute
        move.l  d4,-(sp)                ; sign of D
        normalise
        move.l  d0,d7                   ; D's upper 32 significant bits
        move.l  d2,d6                   ; shifts
        cross   s,y
        bsr.s   .divide
        cross   x,s
        bsr.s   .divide
        cross   t,y
        bsr.s   .divide
        cross   x,t
        bsr.s   .divide
        move.l  (sp)+,d0
.line   movem.l (sp)+,d2-d7/a2
        rts

; (a2)+ = d0:d1 / D in 32.32
.divide move.l  d0,d2
        or.l    d1,d2
        beq     .store                  ; zero
        move.l  4(sp),d4
        absolute
        normalise
        lsr.l   #1,d0                   ; below the divisor: no overflow
        roxr.l  #1,d1
        divu.l  d7,d0:d1
        move.l  d1,d3                   ; upper half of the quotient
        moveq   #0,d1
        divu.l  d7,d0:d1
        move.l  d3,d0                   ; d0:d1 = quotient * 2^(31 + shifts - D's)
        add.l   #31,d2
        sub.l   d6,d2
        bmi.s   .left
        cmp.l   #32,d2
        blo.s   .right
        move.l  d0,d1
        moveq   #0,d0
        sub.l   #32,d2
.right  move.l  d0,d3
        lsr.l   d2,d0                   ; by 32 to 63 gives 0
        lsr.l   d2,d1
        neg.l   d2
        add.l   #32,d2
        lsl.l   d2,d3
        or.l    d3,d1
        bra.s   .sign
.left   neg.l   d2
        move.l  d1,d3
        lsl.l   d2,d0
        lsl.l   d2,d1
        neg.l   d2
        add.l   #32,d2
        lsr.l   d2,d3
        or.l    d3,d0
.sign   tst.l   d4
        bpl.s   .store
        neg.l   d1
        negx.l  d0
.store  move.l  d0,(a2)+
        move.l  d1,(a2)+
        rts
