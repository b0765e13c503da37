        include "routine.i"

; depth_convex - whether a polygon turns to one side only
;
; in:      a0  const vertex*  its vertices
;          d0  int32          how many, 3 or more
; out:     d0  int32          0: at one corner it turns left, at another right; else 1
; reads:   x and y of the vertices
; formats: 16.16, two x or two y less than 2^31 apart
; cost:    about 160 cycles a vertex
        routine depth_convex,a0,d0
        movem.l d2-d7/a2,-(sp)
        subq.l  #1,d0
        move.l  d0,d7
        mulu.w  #vertex_sizeof,d0
        lea     (a0,d0.l),a1
        movea.l a0,a2
        moveq   #0,d6                   ; bit 0, bit 1: it turns to one side, to the other
        movem.l (a0),d4-d5              ; x and y: the way from the last vertex to the first
        sub.l   vertex_x(a1),d4
        sub.l   vertex_y(a1),d5
.vertex lea     vertex_sizeof(a0),a1
        tst.w   d7
        bne.s   .next
        movea.l a2,a1
.next   movem.l (a1),d2-d3
        sub.l   vertex_x(a0),d2
        sub.l   vertex_y(a0),d3
        move.l  d2,d1
        muls.l  d5,d0:d1
        muls.l  d3,d5:d4
        sub.l   d1,d4
        subx.l  d0,d5
        beq.s   .straight               ; Z is that of both halves
        slt     d0
        addq.b  #2,d0                   ; 1 or 2
        or.b    d0,d6
.straight
        move.l  d2,d4
        move.l  d3,d5
        movea.l a1,a0
        dbf     d7,.vertex
        moveq   #1,d0
        subq.b  #3,d6
        bne.s   .done
        moveq   #0,d0
.done   movem.l (sp)+,d2-d7/a2
        rts
