        include "routine.i"

; The corner \1: all of it if it is the first, or the vector from the first. Uses d0-d2/d4/a2.
corner  macro
        movea.l corner_source_\1(a1),a2
        move.l  vertex_w(a2),d4
        move.l  d6,d1
        move.l  d4,d2
        lsr.l   #1,d2
        move.l  d7,d0
        add.l   d2,d0
        moveq   #0,d2
        addx.l  d2,d1
        divu.l  d4,d1:d0                ; q
        put     \1,x,vertex_x(a2)
        put     \1,y,vertex_y(a2)
        times_q s,u
        put     \1,s,d1
        times_q t,v
        put     \1,t,d1
        put     \1,q,d0
        endm

; The field \2 of the corner \1 = \3. Uses d4.
put     macro
        move.l  \3,d4
        ifnc    '\1','first'
        sub.l   plane_corners_first+plane_corner_\2(a0),d4
        endc
        move.l  d4,plane_corners_\1+plane_corner_\2(a0)
        endm

; d1 = the vertex's \1 less the base \2, times q / 2^scale, rounded down: the upper half of twice the product, as
; less than 2^scale is multiplied by 2^d5. Uses d2.
times_q macro
        move.l  vertex_\1(a2),d2
        sub.l   corner_source_\2(a1),d2
        lsl.l   d5,d2
        muls.l  d0,d1:d2
        add.l   d2,d2
        addx.l  d1,d1
        endm

; corners_find - q, s and t of three corners, as two vectors from the first
;
; in:      a0  plane_corners*  first, a and b to fill in
;          a1  const corner_source*  the vertices, the bases, the nearest w and the scale
; reads:   the source, its vertices
; writes:  first, a, b
; formats: q = nearest / w, 2.30, rounded to the nearest; s = q (s less its base) / 2^(scale - 30),
;          rounded down, and so t
; error:   of q half a unit; of s one and q's
; cost:    about 900 cycles
        routine corners_find,a0,a1
        movem.l d2/d4-d7/a2,-(sp)
        pea     corners_kept(pc)
        xdef    corners_inside,_corners_inside
; As corners_find; keeps d3/a0-a1/a3-a6.
_corners_inside
corners_inside
        moveq   #31,d5
        sub.l   corner_source_scale(a1),d5
        move.l  corner_source_nearest(a1),d7
        move.l  d7,d6
        lsr.l   #2,d6
        ror.l   #2,d7
        and.l   #$c0000000,d7           ; d6:d7 = nearest, 2.30
        corner  first
        corner  a
        corner  b
        rts
corners_kept
        movem.l (sp)+,d2/d4-d7/a2
        rts
