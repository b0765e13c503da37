        include "outline.i"

        xref    texturing_gentle_from

; d0 = \1 or d0 with bit 31 set where it is not in -POLYGON_FAR to POLYGON_FAR: d7 = POLYGON_FAR in
; 16.16. Uses d1.
in_range macro
        move.l  \1,d1
        add.l   d7,d1
        or.l    d1,d0
        endm

; Goes to .far if \1 is not in this range. Uses d0.
place_in_range macro
        move.l  \1,d0
        add.l   d7,d0
        bmi     .far
        endm

; Exchanges two vertices: x \1, \3, y \2, \4 and addresses \5, \6.
turn    macro
        exg     \1,\3
        exg     \2,\4
        exg     \5,\6
        endm

; On the stack: the vectors from the top to the bottom and to the middle vertex, as texturing_gentle takes
; them, and the chain.
bottom  equ     0
middle  equ     16
chain   equ     32

; triangle_outline - what polygon_outline finds, for three vertices
;
; in:      a6  setup*  the polygon; with a chain, the cuts of its texturing are set
;          a2  vertex*  the first of the three
;          a5  void*   edge_exact_across or edge_rounded_across
;          d1  int32   enum chain; below 0: the plane is not found
; out:     d0  int32   as polygon_outline
; trashes: d1-d7/a0-a5
; reads:   as polygon_outline
; writes:  as polygon_outline, but first, last and left_step of the sides; if nothing is drawn, a part of it
; formats: as polygon_outline
; error:   as polygon_outline
; cost:    about 1,500 cycles with exact edges and a cold cache; with its plane 2,950

; Vertices: a2 is the top one, a4 the middle one, a3 the bottom one. One side is the edge from top to
; bottom, the other has two edges, which meet at the middle; one of these may cover no line.
        routine triangle_outline
        move.l  d1,-(sp)
        lea     -chain(sp),sp
        lea     vertex_sizeof(a2),a4
        lea     2*vertex_sizeof(a2),a3
        move.l  #POLYGON_FAR<<16,d7
        move.l  vertex_s(a2),d0
        add.l   d7,d0
        in_range vertex_t(a2)
        in_range vertex_s(a4)
        in_range vertex_t(a4)
        in_range vertex_s(a3)
        in_range vertex_t(a3)
        tst.l   d0
        bmi     .far

        movem.l (a2),d1-d2
        movem.l (a4),d3-d4
        movem.l (a3),d5-d6
        cmp.l   d2,d4
        bgt.s   .two
        blt.s   .first
        cmp.l   d1,d3
        bge.s   .two
.first  turn    d1,d2,d3,d4,a2,a4
.two    cmp.l   d4,d6
        bgt.s   .ordered
        beq.s   .level
        turn    d3,d4,d5,d6,a4,a3
        cmp.l   d2,d4
        bgt.s   .ordered
        blt.s   .third
        cmp.l   d1,d3
        bge.s   .ordered
.third  turn    d1,d2,d3,d4,a2,a4
        cmp.l   d4,d6
        bne.s   .ordered
.level  cmp.l   d3,d5                   ; the bottom is the left one of two
        ble.s   .ordered
        exg     d3,d5
        exg     a4,a3
.ordered
        movem.l a2-a4,setup_sides+sides_top(a6)         ; bottom, middle
        movea.l d1,a0                   ; least x
        movea.l d1,a1                   ; greatest x
        cmp.l   a0,d3
        bge.s   .not_least
        movea.l d3,a0
        bra.s   .third_x
.not_least
        movea.l d3,a1
.third_x
        cmp.l   a0,d5
        bge.s   .least
        movea.l d5,a0
.least  cmp.l   a1,d5
        ble.s   .greatest
        movea.l d5,a1
.greatest
        movem.l a0-a1,setup_sides+sides_x_low(a6)       ; and x_high
        place_in_range a0
        place_in_range a1
        place_in_range d2
        place_in_range d6

        sub.l   d1,d3                   ; from the top to the middle
        sub.l   d2,d4
        sub.l   d1,d5                   ; and to the bottom
        sub.l   d2,d6
        movem.l d3-d4,middle(sp)
        movem.l d5-d6,bottom(sp)
        muls.l  d5,d0:d4
        muls.l  d6,d5:d3
        sub.l   d3,d4
        subx.l  d5,d0
        smi     setup_sides+sides_middle_right(a6)
        minus   <neg.l d4>,<negx.l d0>
        move.l  d0,setup_sides+sides_area+number64_hi(a6)
        move.l  d4,setup_sides+sides_area+number64_lo(a6)
        or.l    d0,d4
        beq     .empty

        movea.l setup_frame(a6),a1
        move.l  a0,d3
        sub.l   #EDGE_ERROR,d3
        box_begin d3
        move.l  setup_sides+sides_x_high(a6),d5
        add.l   #EDGE_ERROR,d5
        box_end d5,frame_width(a1)
        cmp.l   d5,d3
        bge     .empty
        move.l  d2,d4
        box_begin d4
        add.l   d2,d6
        box_end d6,frame_height(a1)
        cmp.l   d6,d4
        bge     .empty
        movem.l d3-d6,setup_box(a6)     ; left, top, right, bottom

        move.l  d4,d1
        swap    d1
        clr.w   d1
        sub.l   d2,d1                   ; from the top vertex to the first line
        move.l  d1,-(sp)
        move.l  vertex_y(a4),d7
        upwards d7                      ; the line where the upper short edge ends
        cmp.l   d6,d7
        ble.s   .end
        move.l  d6,d7
.end    sub.l   d4,d7                   ; lines of the upper short edge
        move.l  d7,-(sp)
        sub.l   d4,d6                   ; all lines
        movea.l setup_edges+edge_plan_left(a6),a0
        movea.l setup_edges+edge_plan_right(a6),a1
        tst.b   setup_sides+sides_middle_right(a6)
        bne.s   .long
        exg     a0,a1
.long   movem.l d4/d6/a2-a3,edge_top(a0)        ; lines, upper, lower
        movem.l bottom+8(sp),d4-d5
        move.l  (a2),d7
        jsr     (a5)

        movea.l a1,a0
        move.l  (sp)+,d6
        move.l  (sp)+,d1
        move.l  setup_box+rectangle_top(a6),d4
        tst.l   d6
        ble.s   .lower
        movem.l d4/d6/a2/a4,edge_top(a0)
        movem.l middle(sp),d4-d5
        move.l  (a2),d7
        jsr     (a5)
        move.l  edge_top(a0),d4
        add.l   d6,d4
        cmp.l   setup_box+rectangle_bottom(a6),d4
        bge.s   .made
        lea     edge_sizeof(a0),a0
.lower  move.l  d4,d1
        swap    d1
        clr.w   d1
        sub.l   vertex_y(a4),d1
        move.l  setup_box+rectangle_bottom(a6),d6
        sub.l   d4,d6
        movem.l d4/d6,edge_top(a0)
        move.l  a4,edge_upper(a0)
        move.l  a3,edge_lower(a0)
        movem.l bottom(sp),d4-d5
        sub.l   middle(sp),d4
        sub.l   middle+4(sp),d5
        move.l  (a4),d7
        jsr     (a5)
.made   moveq   #1,d0
        moveq   #1,d1
        cmpa.l  a1,a0
        beq.s   .one
        moveq   #2,d0
.one    tst.b   setup_sides+sides_middle_right(a6)
        beq.s   .sides
        exg     d0,d1
.sides  movem.l d0-d1,setup_edges+edge_plan_lefts(a6)   ; and rights

        move.l  chain(sp),d0
        bmi.s   .drawn
        movem.l (a2),d4-d7
        movem.l d6-d7,setup_texturing+texturing_u(a6)   ; and v
        movem.l vertex_s(a4),d0-d1
        sub.l   d6,d0
        sub.l   d7,d1
        movem.l d0-d1,middle+8(sp)
        movem.l vertex_s(a3),d0-d1
        sub.l   d6,d0
        sub.l   d7,d1
        movem.l d0-d1,bottom+8(sp)
        movea.l sp,a2
        lea     middle(sp),a3
        tst.b   setup_sides+sides_middle_right(a6)
        beq.s   .turned
        exg     a2,a3
.turned jmp     texturing_gentle_from
.drawn  moveq   #POLYGON_DRAWN,d0
.done   lea     chain+4(sp),sp
        rts
.empty  moveq   #POLYGON_EMPTY,d0
        bra.s   .done
.far    moveq   #POLYGON_OUTSIDE_RANGE,d0
        bra.s   .done
