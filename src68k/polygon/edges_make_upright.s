        include "routine.i"

        xref    edges_of_sides,edge_exact_upright

; edges_make_upright - exact edges of a polygon whose lines are columns of the frame
;
; in:      a0  edge_plan*  left, right: where to write edges; the others are not read
;          a1  sides*      of the vertices with x and y exchanged
;          d0  rectangle*  the columns that the polygon covers, as lines, one at least
; reads:   *sides, its vertices, top and bottom of the rectangle
; writes:  plan: lefts, rights; that many edges each: all fields except u, v, du, dv
; formats: as edge_exact_upright
; cost:    about 2,000 cycles for a triangle, with a cold cache
        routine edges_make_upright,a0,a1,d0
        save_all
        movea.l d0,a2
        lea     edge_exact_upright,a5
        jmp     edges_of_sides
