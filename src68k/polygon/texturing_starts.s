        include "starts.i"

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
.edge   start_edge
        lea     edge_sizeof(a1),a1
        dbra    d7,.edge
        movem.l (sp)+,d2-d7
        rts
