        include "routine.i"

; Goes to .far if \1 is not in -POLYGON_FAR to POLYGON_FAR: the upper two bits
; of such a 16.16 number differ. Uses d0.
in_range macro
        move.l  \1,d0
        add.l   d0,d0
        bvs     .far
        endm

; Notes the vertex a1 in \1 (its y) and \2 if d2 = y is beyond \1, or the same and d1 = x less. \3,
; \4: the branches if it is not, and if it is.
extreme macro
        cmp.l   \1,d2
        \3.s   .not\@
        \4.s   .yes\@
        cmp.l   vertex_x(\2),d1
        bge.s   .not\@
.yes\@  move.l  d2,\1
        movea.l a1,\2
.not\@
        endm

; sides_find - a polygon's top and bottom vertex, and which side is left
;
; in:      a0  sides*   the sides to fill in
;          a1  vertex*  the vertices, in order
;          d0  int32    how many, 3 or more
; out:     d0  int32    POLYGON_DRAWN; POLYGON_OUTSIDE_RANGE: a coordinate is not in
;                       -POLYGON_FAR to POLYGON_FAR; POLYGON_EMPTY: no area
; reads:   x, y, s, t of the vertices
; writes:  *sides; not all of it if the polygon is refused
; formats: 16.16; area 32.32, below 2^63
; cost:    about 400 cycles a vertex with a cold cache
        routine sides_find,a0,a1,d0
        movem.l d2-d7/a2-a4,-(sp)
        move.w  d0,d7
        subq.w  #1,d7
        move.l  a1,sides_first(a0)
        movea.l a1,a2                   ; top
        movea.l a1,a3                   ; bottom
        move.l  vertex_y(a1),d3         ; its y
        move.l  d3,d4                   ; the bottom's
        move.l  vertex_x(a1),d5         ; least x
        move.l  d5,d6                   ; greatest

.vertex move.l  vertex_x(a1),d1
        in_range d1
        move.l  vertex_y(a1),d2
        in_range d2
        in_range vertex_s(a1)
        in_range vertex_t(a1)
        cmp.l   d5,d1
        bge.s   .not_least
        move.l  d1,d5
.not_least
        cmp.l   d6,d1
        ble.s   .not_greatest
        move.l  d1,d6
.not_greatest
        extreme d3,a2,bgt,blt
        extreme d4,a3,blt,bgt
        lea     vertex_sizeof(a1),a1
        dbra    d7,.vertex

        move.l  d5,sides_x_low(a0)
        move.l  d6,sides_x_high(a0)
        move.l  a2,sides_top(a0)
        move.l  a3,sides_bottom(a0)
        lea     -vertex_sizeof(a1),a4
        move.l  a4,sides_last(a0)
        sub.l   d3,d4                   ; down: from top to bottom
        move.l  vertex_x(a3),d5
        sub.l   vertex_x(a2),d5
        moveq   #0,d6                   ; d6:d7 the largest cross product so far
        moveq   #0,d7

        ; The middle is the vertex farthest from the line from top to bottom; of several
        ; the topmost, then the leftmost, so that their order does not matter.
        movea.l sides_first(a0),a1
.turn   cmpa.l  a1,a2
        beq.s   .turned
        cmpa.l  a1,a3
        beq.s   .turned
        move.l  vertex_y(a1),d1
        sub.l   vertex_y(a2),d1
        muls.l  d5,d0:d1
        move.l  vertex_x(a1),d3
        sub.l   vertex_x(a2),d3
        muls.l  d4,d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        smi     d2                      ; on the right
        minus   <neg.l d1>,<negx.l d0>
        cmp.l   d6,d0
        bhi.s   .middle
        bne.s   .turned
        cmp.l   d7,d1
        bhi.s   .middle
        bne.s   .turned
        move.l  d0,d3
        or.l    d1,d3
        beq.s   .turned                 ; on the line
        move.l  vertex_y(a1),d3
        cmp.l   vertex_y(a4),d3
        blt.s   .middle
        bne.s   .turned
        move.l  vertex_x(a1),d3
        cmp.l   vertex_x(a4),d3
        bge.s   .turned
.middle   move.l  d0,d6
        move.l  d1,d7
        movea.l a1,a4
        move.b  d2,sides_middle_right(a0)
.turned cmpa.l  sides_last(a0),a1
        lea     vertex_sizeof(a1),a1
        bne.s   .turn

        move.l  d6,d0
        or.l    d7,d0
        beq.s   .empty
        movem.l d6-d7,sides_area(a0)
        move.l  a4,sides_middle(a0)

        ; Of top < middle, middle < bottom and bottom < top two are true if the vertices are in
        ; that order, and one if they are in the other.
        cmpa.l  a4,a2
        scs     d0
        cmpa.l  a3,a4
        scs     d1
        eor.b   d1,d0
        cmpa.l  a2,a3
        scs     d1
        eor.b   d1,d0                   ; 0: the middle comes before the bottom
        move.b  sides_middle_right(a0),d1
        eor.b   d1,d0                   ; 0: and is on the left; or neither
        moveq   #vertex_sizeof,d1
        tst.b   d0
        beq.s   .step
        neg.l   d1
.step   move.l  d1,sides_left_step(a0)
        moveq   #POLYGON_DRAWN,d0
.done   movem.l (sp)+,d2-d7/a2-a4
        rts
.far    moveq   #POLYGON_OUTSIDE_RANGE,d0
        bra.s   .done
.empty  moveq   #POLYGON_EMPTY,d0
        bra.s   .done
