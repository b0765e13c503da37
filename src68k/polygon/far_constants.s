        include "routine.i"

; d1 = C where u less its base is \1 and q is \2; a1: K, a3: bits. Uses d0/d2-d3.
constant macro
        move.l  \1,d1
        sub.l   a1,d1
        muls.l  \2,d0:d1
        move.l  a3,d2
        lsl.l   d2,d0
        moveq   #32,d3
        sub.l   d2,d3
        lsr.l   d3,d1
        or.l    d0,d1
        endm

; C of \1, u or v, and its growth a line.
constants macro
        movea.l far_plan_k\1(a0),a1
        constant far_plan_top_\1(a0),d6
        move.l  d1,d4
        constant far_plan_bottom_\1(a0),d7
        sub.l   d4,d1
        bvs     .not
        move.l  d1,d0
        swap    d0
        ext.l   d0
        swap    d1
        clr.w   d1
        divs.l  d5,d0:d1
        bvs     .not
        move.l  d1,far_plan_dc\1(a0)
        move.l  d0,far_plan_rest_\1(a0)
        muls.l  plane_corners_y(a2),d0:d1
        move.w  d0,d1
        swap    d1
        add.l   d1,d4
        move.l  d4,far_plan_c\1(a0)
        endm

; far_constants - C of the first line and its growth, for lines from their far ends
;
; in:      a0  far_plan*  K, corners, bottom, u and v of the top and the bottom, as K; C to fill in
;          d0  int32      bits: 5, or 1 if C is coarse or coarser
; out:     d0  int32      1; 0 if C does not fit: the polygon is lower than a line, or K too far away
; reads:   the plan
; writes:  cu, cv, dcu, dcv, rest_u, rest_v
; formats: C = (u - K) q at the top and the bottom, in units * 2^(bits - 32), as struct far_span's; between
;          them it changes by the same from line to line
; error:   of C a unit at the top and one of the first line's; of dc one, and one over the height
; cost:    about 700 cycles
        routine far_constants,a0,d0
        save_all
        pea     constants_kept(pc)
        xdef    constants_inside,_constants_inside
; As far_constants; keeps a0/a4-a6.
_constants_inside
constants_inside
        movea.l d0,a3
        movea.l far_plan_corners(a0),a2
        movea.l far_plan_bottom(a0),a1
        move.l  plane_corner_y(a1),d5
        move.l  plane_corners_first+plane_corner_q(a2),d6
        move.l  plane_corner_q(a1),d7
        add.l   d6,d7
        constants u
        constants v
        moveq   #1,d0
        rts
.not    moveq   #0,d0
        rts
constants_kept
        return_all
