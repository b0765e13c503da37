        include "routine.i"

; d0 = \1 or d0 with bit 31 set where it is not in -POLYGON_FAR to POLYGON_FAR: a1 = POLYGON_FAR in
; 16.16. Uses d7.
in_range macro
        move.l  \1,d7
        add.l   a1,d7
        or.l    d7,d0
        endm

; Exchanges two vertices: x \1, \3, y \2, \4 and addresses \5, \6.
turn    macro
        exg     \1,\3
        exg     \2,\4
        exg     \5,\6
        endm

; sides_three - what sides_find finds, for three vertices
;
; in:      a0  sides*   the sides to fill in
;          a1  vertex*  the three vertices, in order
; out:     d0  int32    as sides_find
; trashes: d0-d7/a1-a4
; reads:   x, y, s, t of the vertices
; writes:  *sides; not all of it if the triangle is refused
; formats: as sides_find
; cost:    about 450 cycles with a cold cache

; Three compares order the vertices by y, then by x.
        routine sides_three
        move.l  a1,sides_first(a0)
        movea.l a1,a2                   ; top
        lea     vertex_sizeof(a1),a3    ; middle
        lea     2*vertex_sizeof(a1),a4  ; bottom
        move.l  a4,sides_last(a0)
        movea.l #POLYGON_FAR<<16,a1
        move.l  vertex_s(a2),d0
        add.l   a1,d0
        in_range vertex_t(a2)
        in_range vertex_s(a3)
        in_range vertex_t(a3)
        in_range vertex_s(a4)
        in_range vertex_t(a4)
        move.l  (a2),d1
        in_range d1
        move.l  vertex_y(a2),d2
        in_range d2
        move.l  (a3),d3
        in_range d3
        move.l  vertex_y(a3),d4
        in_range d4
        move.l  (a4),d5
        in_range d5
        move.l  vertex_y(a4),d6
        in_range d6
        tst.l   d0
        bmi     .far

        cmp.l   d2,d4
        bgt.s   .two
        blt.s   .first
        cmp.l   d1,d3
        bge.s   .two
.first  turn    d1,d2,d3,d4,a2,a3
.two    cmp.l   d4,d6
        bgt.s   .ordered
        beq.s   .level
        turn    d3,d4,d5,d6,a3,a4
        cmp.l   d2,d4
        bgt.s   .ordered
        blt.s   .third
        cmp.l   d1,d3
        bge.s   .ordered
.third  turn    d1,d2,d3,d4,a2,a3
        cmp.l   d4,d6
        bne.s   .ordered
.level  cmp.l   d3,d5                   ; the bottom is the left one of two
        ble.s   .ordered
        exg     d3,d5
        exg     a3,a4
.ordered
        movem.l a2/a4,sides_top(a0)     ; and bottom
        move.l  a3,sides_middle(a0)

        move.l  d1,d0
        move.l  d1,d7
        cmp.l   d3,d0
        ble.s   .not_least
        move.l  d3,d0
.not_least
        cmp.l   d3,d7
        bge.s   .not_greatest
        move.l  d3,d7
.not_greatest
        cmp.l   d5,d0
        ble.s   .least
        move.l  d5,d0
.least  cmp.l   d5,d7
        bge.s   .greatest
        move.l  d5,d7
.greatest
        movem.l d0/d7,sides_x_low(a0)   ; and x_high

        sub.l   d1,d3                   ; from the top to the middle
        sub.l   d2,d4
        sub.l   d1,d5                   ; and to the bottom
        sub.l   d2,d6
        muls.l  d5,d0:d4
        muls.l  d6,d2:d3
        sub.l   d3,d4
        subx.l  d2,d0
        smi     d1                      ; the middle is on the right
        minus   <neg.l d4>,<negx.l d0>
        move.l  d0,d2
        or.l    d4,d2
        beq.s   .empty
        move.l  d0,sides_area+number64_hi(a0)
        move.l  d4,sides_area+number64_lo(a0)
        move.b  d1,sides_middle_right(a0)

        ; As in sides_find: the three in the order of the vertices or in the other, and the middle
        ; on the left or right.
        cmpa.l  a3,a2
        scs     d0
        eor.b   d0,d1
        cmpa.l  a4,a3
        scs     d0
        eor.b   d0,d1
        cmpa.l  a2,a4
        scs     d0
        moveq   #vertex_sizeof,d2
        eor.b   d0,d1
        beq.s   .step
        neg.l   d2
.step   move.l  d2,sides_left_step(a0)
        moveq   #POLYGON_DRAWN,d0
        rts
.far    moveq   #POLYGON_OUTSIDE_RANGE,d0
        rts
.empty  moveq   #POLYGON_EMPTY,d0
        rts
