        include "routine.i"

; d0:d1 = the plane \1 of the plan a5, d6 pixels right of its own pixel and d7 below.
; Uses d2-d3.
at      macro
        movem.l perspective_plan_\1+screen_plane_at(a5),d0-d1
        part    \1,dx,d6
        part    \1,dy,d7
        endm

part    macro
        move.l  perspective_plan_\1+screen_plane_\2+number64_lo(a5),d3
        mulu.l  \3,d2:d3
        add.l   d3,d1
        addx.l  d2,d0
        move.l  perspective_plan_\1+screen_plane_\2(a5),d2
        muls.l  \3,d2
        add.l   d2,d0
        endm

; d0:d1 = d0:d1 - d4:d5 * d2:d3, both 32.32, rounded down, with an error of up to 3 units.
; Uses d2-d3/a1-a2.
less_product macro
        movea.l d6,a1
        movea.l d7,a2
        move.l  d3,d7
        mulu.l  d4,d6:d7                ; signed by unsigned
        tst.l   d4
        bpl.s   .first\@
        sub.l   d3,d6
.first\@
        move.l  d6,d3
        bsr     .less
        move.l  d5,d7
        mulu.l  d2,d6:d7
        tst.l   d2
        bpl.s   .second\@
        sub.l   d5,d6
.second\@
        move.l  d6,d3
        bsr     .less
        muls.l  d4,d3:d2
        sub.l   d2,d1
        subx.l  d3,d0
        move.l  a1,d6
        move.l  a2,d7
        endm

; K and C of \1, u or v, from the plane \2.
constant macro
        movem.l perspective_plan_\2+screen_plane_dx(a5),d0-d1
        movem.l perspective_plan_q+screen_plane_dx(a5),d2-d3
        movea.l d0,a1
        tst.l   d0
        minus   <neg.l d1>,<negx.l d0>
        tst.l   d2
        bpl.s   .grows\@
        neg.l   d3
        negx.l  d2
        exg     d0,a1
        not.l   d0
        exg     d0,a1
.grows\@
        cmp.l   #FLAT,d2
        blo     .not
        moveq   #RECIPROCAL_BITS,d6
        moveq   #32-RECIPROCAL_BITS,d7
        move.l  d0,d5
        lsr.l   d7,d5
        bne     .not
        move.l  d0,d4
        lsl.l   d6,d4
        move.l  d1,d5
        lsr.l   d7,d5
        or.l    d5,d4
        cmp.l   d2,d4
        bhs     .not                    ; K would be 2^(16 - RECIPROCAL_BITS) texels or more
        bfffo   d2{0:32},d7
        moveq   #32,d6
        sub.l   d7,d6
        lsl.l   d7,d2
        lsr.l   d6,d3
        or.l    d3,d2                   ; 32 bits of the divisor
        move.l  d1,d4
        lsl.l   d7,d0
        lsr.l   d6,d4
        or.l    d4,d0
        lsl.l   d7,d1
        divu.l  d2,d0:d1
        move.l  d1,d4
        moveq   #0,d5
        divu.l  d2,d0:d5
        move.l  a1,d0
        minus   <neg.l d5>,<negx.l d4>
        move.l  d4,reciprocal_plan_k\1(a0)      ; d4:d5 = K
        movem.l perspective_plan_\2+screen_plane_dy(a5),d0-d1
        movem.l perspective_plan_q+screen_plane_dy(a5),d2-d3
        less_product
        bsr     .grown
        movem.l d0-d1,reciprocal_plan_dc\1(a0)
        movem.l (sp),d6-d7
        at      q
        movea.l d0,a3
        movea.l d1,a4
        at      \2
        move.l  a3,d2
        move.l  a4,d3
        less_product
        bsr     .grown
        move.l  reciprocal_plan_dc\1+number64_lo(a0),d3
        mulu.l  d7,d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        move.l  reciprocal_plan_dc\1(a0),d2
        muls.l  d7,d2
        sub.l   d2,d0
        movem.l d0-d1,reciprocal_plan_c\1(a0)
        endm

FLAT    equ     1<<8                    ; if q grows less than this a pixel, no line is taken

; reciprocal_find - the constants of a polygon's lines by reciprocals
;
; in:      a0  reciprocal_plan*  the plan to fill in; its planes
;          d0  int32             a pixel of the polygon: its distance to the right
;          d1  int32             and down from that of the planes
; out:     d0  int32             1; 0 if K of u or v is 2^(16 - RECIPROCAL_BITS) texels or more from the base
; reads:   the plan's planes
; writes:  cu, cv, dcu, dcv; ku and kv, less their bases
; formats: K = (ds/dx) / (dq/dx), 32.32 here and 16.16 in the plan; C = s - K q,
;          which does not change along a line. No gradient of q by x or y, nor of s
;          and t by x, reaches 2^30 times their unit of q.hi a pixel
; error:   of K |K| / 2^31; of C 3 units of 2^-64 of the planes' own, times the lines
; cost:    about 2,700 cycles
        routine reciprocal_find,a0,d0,d1
        save_all
        movea.l reciprocal_plan_planes(a0),a5
        movem.l d0-d1,-(sp)
        constant u,s
        constant v,t
        moveq   #1,d0
.out    addq.l  #8,sp
        return_all
.not    moveq   #0,d0
        bra.s   .out

; d0:d1 = d0:d1 - d3, which is sign-extended.
.less   tst.l   d3
        smi     d7
        extb.l  d7
        sub.l   d3,d1
        subx.l  d7,d0
        rts

; d0:d1 = d0:d1 times 2^RECIPROCAL_BITS. Uses d2-d3.
.grown  move.l  d1,d2
        moveq   #32-RECIPROCAL_BITS,d3
        lsl.l   #RECIPROCAL_BITS,d0
        lsr.l   d3,d2
        or.l    d2,d0
        lsl.l   #RECIPROCAL_BITS,d1
        rts
