        include "routine.i"

; shade_vertices - the vertices of a Gouraud polygon, with shades for s
;
; in:      a0  vertex*  where to make them
;          a1  vertex*  the given ones
;          d0  int32    how many, 1 or more
;          d1  int32    mask of x and y
; reads:   x, y, shade of the given ones
; writes:  x, y, s of the others; t: 0
; formats: 16.16; a shade is moved into the range from SHADE_INSET above the least shade, cut to a
;          whole one, to as much below the next whole one above the greatest
; cost:    about 130 cycles a vertex, plus 100
        routine shade_vertices,a0,a1,d0,d1
        movem.l d2-d5,-(sp)
        subq.w  #1,d0
        move.l  d0,d5
        move.l  a1,-(sp)
        move.l  vertex_shade(a1),d2     ; least
        move.l  d2,d3                   ; greatest
        bra.s   .next
.range  lea     vertex_sizeof(a1),a1
        move.l  vertex_shade(a1),d4
        cmp.l   d4,d2
        ble.s   .not_least
        move.l  d4,d2
.not_least
        cmp.l   d4,d3
        bge.s   .next
        move.l  d4,d3
.next   dbra    d5,.range
        movea.l (sp)+,a1
        clr.w   d2
        add.l   #SHADE_INSET,d2
        move.w  #$ffff-SHADE_INSET,d3

.vertex move.l  (a1),d4
        and.l   d1,d4
        move.l  d4,(a0)
        move.l  vertex_y(a1),d4
        and.l   d1,d4
        move.l  d4,vertex_y(a0)
        move.l  vertex_shade(a1),d4
        cmp.l   d2,d4
        bge.s   .not_below
        move.l  d2,d4
        bra.s   .limited
.not_below
        cmp.l   d3,d4
        ble.s   .limited
        move.l  d3,d4
.limited
        move.l  d4,vertex_s(a0)
        clr.l   vertex_t(a0)
        lea     vertex_sizeof(a0),a0
        lea     vertex_sizeof(a1),a1
        dbra    d0,.vertex
        movem.l (sp)+,d2-d5
        rts
