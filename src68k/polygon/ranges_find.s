        include "routine.i"

; Extends the range \1 to \2 by the vertex's \3. Uses d0.
extend  macro
        move.l  vertex_\3(a2),d0
        cmp.l   \1,d0
        bge.s   .low\@
        move.l  d0,\1
.low\@  cmp.l   \2,d0
        ble.s   .high\@
        move.l  d0,\2
.high\@
        endm

; The base of the range \1 to \2 of \3, u or v; d7 = d7 or the range's farthest ends from it. Uses d0.
based   macro
        move.l  \1,d0
        add.l   \2,d0
        asr.l   #1,d0
        clr.w   d0
        sub.l   d0,\1
        sub.l   d0,\2
        move.l  d0,corner_source_\3(a0)
        addq.l  #1,d0
        move.l  d0,perspective_plan_\3(a1)
        move.l  \1,perspective_plan_\3_low(a1)
        move.l  \2,perspective_plan_\3_high(a1)
        or.l    \2,d7
        neg.l   \1
        bmi.s   .below\@                ; the base is below the whole range
        or.l    \1,d7
.below\@
        endm

; ranges_find - the bases of u and v, their ranges less these, the scale of s and t, and the least w of a polygon
;
; in:      a0  corner_source*     u, v, nearest and scale to fill in
;          a1  perspective_plan*  u, v and their ranges to fill in
;          d0  const vertex*      the vertices
;          d1  int32              how many, 3 or more
; reads:   s, t and w of the vertices
; writes:  the source's u, v, nearest, scale; the plan's u, u_low, u_high, v, v_low, v_high
; formats: 16.16. A base is the middle of the range, rounded down to a texel; the plan's is a unit above. The scale
;          is that of the power of two above all that is left of u and v, 16 or more
; cost:    about 300 cycles for 3 vertices
        routine ranges_find,a0,a1,d0,d1
        movem.l d2-d7/a2,-(sp)
        pea     ranges_kept(pc)
        xdef    ranges_inside,_ranges_inside
; As ranges_find; keeps a0-a1/a3-a6.
_ranges_inside
ranges_inside
        movea.l d0,a2
        move.l  vertex_w(a2),d2
        move.l  vertex_s(a2),d3
        move.l  d3,d4
        move.l  vertex_t(a2),d5
        move.l  d5,d6
        subq.w  #2,d1
.vertex lea     vertex_sizeof(a2),a2
        move.l  vertex_w(a2),d0
        cmp.l   d2,d0
        bge.s   .farther
        move.l  d0,d2
.farther
        extend  d3,d4,s
        extend  d5,d6,t
        dbra    d1,.vertex
        move.l  d2,corner_source_nearest(a0)
        moveq   #0,d7
        based   d3,d4,u
        based   d5,d6,v
        bfffo   d7{0:32},d0
        moveq   #32,d1
        sub.l   d0,d1
        moveq   #16,d0
        cmp.l   d0,d1
        bge.s   .scale
        move.l  d0,d1
.scale  move.l  d1,corner_source_scale(a0)
        rts
ranges_kept
        movem.l (sp)+,d2-d7/a2
        rts
