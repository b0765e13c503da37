        include "starts.i"

; Finds \1, u or v, and its step where the edge a1 begins: d2, d3 = its distance from pixel (i, j),
; d4 = its whole pixels a line. Uses d0-d1/d5-d6.
start   macro
        start_step \1
        move.l  texturing_d\1dy(a0),d5
        muls.l  d2,d0
        muls.l  d3,d5
        add.l   d5,d0
        add.l   texturing_\1(a0),d0
        move.l  d0,edge_\1(a1)
        endm

; texturing_starts - u and v where left edges begin, on the polygon's plane
;
; in:      a0  texturing*  as texturing_plane fills it
;          a1  edge*       the edges, as edges_make fills them
;          d0  int32       how many, 1 or more
; reads:   *texturing; x, whole and top of the edges
; writes:  u, v, du, dv of the edges
; formats: 16.16 modulo 2^32; with x, y counted from pixel (i, j):
;          u + x dudx + y dudy at the first pixel of line top, and
;          du = dudy + whole dudx
; cost:    about 300 cycles an edge, plus 60; with a cold cache 500 for one
        routine texturing_starts,a0,a1,d0
        movem.l d2-d7,-(sp)
        move.w  d0,d7
        subq.w  #1,d7
.edge   move.l  edge_x(a1),d2
        sub.l   #EDGE_BIAS,d2
        sub.l   texturing_i(a0),d2
        move.l  edge_top(a1),d3
        sub.l   texturing_j(a0),d3
        move.l  edge_whole(a1),d4

        start   u
        start   v
        lea     edge_sizeof(a1),a1
        dbra    d7,.edge
        movem.l (sp)+,d2-d7
        rts
