        include "routine.i"

        xref    edge_exact,edge_rounded

; edges_make - the edges of a polygon's sides, from its top line to its bottom one
;
; in:      a0  edge_plan*  left, right: where to write edges; the others are not read
;          a1  sides*      as sides_find fills them
;          d0  rectangle*  the lines that the polygon covers, one at least
;          d1  int32       1: exact edges, 0: rounded ones
; reads:   *sides, its vertices, top and bottom of the rectangle
; writes:  plan: lefts, rights; that many edges each: all fields except u, v, du, dv
; formats: as edge_exact, edge_rounded
; error:   theirs
; cost:    about 2,000 cycles for a triangle, with a cold cache

; Skips edges that cover no line and edges that run upwards: each line gets one left and
; one right edge, whatever the vertices are.

top     equ     8                       ; on the stack in .side: the polygon's lines
bottom  equ     12

        routine edges_make,a0,a1,d0,d1
        save_all
        movea.l d0,a2
        lea     edge_rounded,a5
        tst.l   d1
        beq.s   edges_of_sides
        lea     edge_exact,a5
        xdef    edges_of_sides,_edges_of_sides
; As edges_make behind save_all. In: a0, a1, a2 the rectangle, a5 the routine for an edge.
_edges_of_sides
edges_of_sides
        move.l  rectangle_bottom(a2),-(sp)
        move.l  rectangle_top(a2),-(sp)
        move.l  a0,-(sp)
        movea.l a1,a4
        movea.l sides_left_step(a1),a6
        lea     edge_plan_lefts(a0),a3
        movea.l edge_plan_left(a0),a0
        bsr.s   .side
        movea.l (sp),a0
        move.l  a6,d0
        neg.l   d0
        movea.l d0,a6
        lea     edge_plan_rights(a0),a3
        movea.l edge_plan_right(a0),a0
        bsr.s   .side
        lea     12(sp),sp
        return_all

; Makes the edges of a side: a0 edges, a3 address of their number, a4 sides, a5 routine, a6 step
.side   clr.l   (a3)
        movea.l sides_top(a4),a2
        move.l  top(sp),d1               ; first line
.vertex movea.l a2,a1                   ; upper
        adda.l  a6,a2
        cmpa.l  sides_first(a4),a2
        bhs.s   .not_before
        movea.l sides_last(a4),a2
.not_before
        cmpa.l  sides_last(a4),a2
        bls.s   .lower
        movea.l sides_first(a4),a2
.lower  move.l  vertex_y(a2),d0
        move.l  d0,d2
        add.l   #$ffff,d0
        swap    d0
        ext.l   d0                      ; the line where it ends
        cmp.l   bottom(sp),d0
        ble.s   .end
        move.l  bottom(sp),d0
.end    sub.l   d1,d0
        ble.s   .vertex
        cmp.l   vertex_y(a1),d2
        ble.s   .vertex
        addq.l  #1,(a3)
        move.l  d0,edge_lines(a0)
        move.l  d1,edge_top(a0)
        move.l  a1,edge_upper(a0)
        move.l  a2,edge_lower(a0)
        jsr     (a5)
        move.l  edge_top(a0),d1
        add.l   edge_lines(a0),d1
        lea     edge_sizeof(a0),a0
        cmp.l   bottom(sp),d1
        blt.s   .vertex
        rts
