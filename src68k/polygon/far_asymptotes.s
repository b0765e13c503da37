        include "routine.i"

; d0:d1 = qa yb - qb ya, where \1 is q, s or t of the vectors a2 and b, a3. Uses d2-d3.
growth  macro
        move.l  plane_corner_\1(a2),d1
        muls.l  plane_corner_y(a3),d0:d1
        move.l  plane_corner_\1(a3),d3
        muls.l  plane_corner_y(a2),d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        endm

; K of \1, u or v, from \2, s or t. d4: shift; d5 = 32 - |d4|; d7: the divisor; a1: its sign.
asymptote macro
        growth  \2
        move.l  a1,d6
        eor.l   d0,d6                   ; sign of the quotient
        tst.l   d0
        minus   <neg.l d1>,<negx.l d0>
        tst.w   d4
        bmi.s   .smaller\@
        move.l  d0,d2
        lsr.l   d5,d2
        bne     .not
        lsl.l   d4,d0
        move.l  d1,d2
        lsr.l   d5,d2
        or.l    d2,d0
        lsl.l   d4,d1
        bra.s   .aligned\@
.smaller\@
        move.w  d4,d3
        neg.w   d3
        lsr.l   d3,d1
        move.l  d0,d2
        lsl.l   d5,d2
        or.l    d2,d1
        lsr.l   d3,d0
.aligned\@
        cmp.l   d7,d0
        bhs     .not
        divu.l  d7,d0:d1
        bmi     .not
        tst.l   d6
        minus   <neg.l d1>
        move.l  d1,far_plan_k\1(a0)
        endm

; far_asymptotes - K of u and v for lines from their far ends
;
; in:      a0  far_plan*  the corners and their scale; K to fill in
; out:     d0  int32      1; 0 if K of u or v is 4,096 texels, times 2^less, from its base, or if q hardly grows
; reads:   corners, scale, less
; writes:  ku, kv
; formats: K = (qa yb - qb ya with s or t for q) / (qa yb - qb ya): what u does for q along a line. 13.19, units / 8,
;          if no bits are less
; error:   of K |K| / 2^31, and its last bit
; cost:    about 600 cycles
        routine far_asymptotes,a0
        save_all
        pea     asymptotes_kept(pc)
        xdef    asymptotes_inside,_asymptotes_inside
; As far_asymptotes; keeps a0/a4-a6.
_asymptotes_inside
asymptotes_inside
        movea.l far_plan_corners(a0),a2
        lea     plane_corners_b(a2),a3
        lea     plane_corners_a(a2),a2
        growth  q
        movea.l d0,a1
        tst.l   d0
        minus   <neg.l d1>,<negx.l d0>
        move.l  d0,d7
        beq     .not
        bfffo   d7{0:32},d4
        lsl.l   d4,d7
        moveq   #32,d5
        sub.l   d4,d5
        lsr.l   d5,d1
        or.l    d1,d7                   ; the growth of q, 32 bits
        add.l   far_plan_scale(a0),d4
        sub.l   far_plan_less(a0),d4
        sub.l   #FAR_K_SCALE,d4
        move.l  d4,d5
        minus   <neg.l d5>
        neg.l   d5
        add.l   #32,d5
        asymptote u,s
        asymptote v,t
        moveq   #1,d0
        rts
.not    moveq   #0,d0
        rts
asymptotes_kept
        return_all
