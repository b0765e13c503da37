        include "routine.i"

        xref    edge_exact,edge_rounded

; edges_three - what edges_make makes, for three vertices
;
; in:      a1  sides*      as sides_find fills them
;          a2  edge_plan*  left, right: where to write edges; the others are not read
;          a4  rectangle*  the lines that the triangle covers, one at least
;          d0  int32       1: exact edges, 0: rounded ones
; trashes: d0-d7/a0-a3/a5-a6
; reads:   *sides, its vertices, top and bottom of the rectangle
; writes:  as edges_make
; formats: as edge_exact, edge_rounded
; error:   theirs
; cost:    about 1,100 cycles with a cold cache

; One side is the edge from top to bottom, the other goes by the middle. Of its two edges one may
; cover no line.
        routine edges_three
        lea     edge_rounded,a5
        tst.l   d0
        beq.s   .chosen
        lea     edge_exact,a5
.chosen
        movea.l a1,a6
        movea.l a2,a3
        movea.l edge_plan_left(a3),a0
        tst.b   sides_middle_right(a6)
        beq.s   .left
        bsr.s   .long
        moveq   #1,d0
        move.l  d0,edge_plan_lefts(a3)
        movea.l edge_plan_right(a3),a0
        bsr.s   .short
        move.l  d0,edge_plan_rights(a3)
        rts
.left   bsr.s   .short
        move.l  d0,edge_plan_lefts(a3)
        moveq   #1,d0
        move.l  d0,edge_plan_rights(a3)
        movea.l edge_plan_right(a3),a0

.long   movem.l sides_top(a6),a1-a2     ; and bottom
        move.l  rectangle_top(a4),d1
        move.l  rectangle_bottom(a4),d0
        sub.l   d1,d0
; From a1 to a2, from line d1 on, d0 lines.
.edge   move.l  d0,edge_lines(a0)
        move.l  d1,edge_top(a0)
        movem.l a1-a2,edge_upper(a0)    ; and lower
        jmp     (a5)

.short  movea.l sides_top(a6),a1
        movea.l sides_middle(a6),a2
        move.l  rectangle_top(a4),d1
        move.l  vertex_y(a2),d0
        add.l   #$ffff,d0
        swap    d0
        ext.l   d0                      ; the line where the upper edge ends
        cmp.l   rectangle_bottom(a4),d0
        ble.s   .end
        move.l  rectangle_bottom(a4),d0
.end    sub.l   d1,d0
        ble.s   .lower
        bsr.s   .edge
        move.l  edge_top(a0),d1
        add.l   edge_lines(a0),d1
        move.l  rectangle_bottom(a4),d0
        sub.l   d1,d0
        ble.s   .one
        lea     edge_sizeof(a0),a0
        bsr.s   .last
        moveq   #2,d0
        rts
.lower  move.l  rectangle_bottom(a4),d0
        sub.l   d1,d0
        bsr.s   .last
.one    moveq   #1,d0
        rts
.last   movea.l a2,a1
        movea.l sides_bottom(a6),a2
        bra.s   .edge
