        include "nearest.i"

; Finds \1, u or v, from \2, s or t, along the edge a0 from a1 to a2, and its step a line: d4 =
; its height, d5 = from the upper end down to the first line. \1 is raised by half of \3 and the edge's
; lines, if that is given and not negative. Uses d0-d3.
along   macro
        move.l  vertex_\2(a1),d3
        move.l  vertex_\2(a2),d0
        sub.l   d3,d0
        move.l  d0,d2
        tst.l   d5
        beq.s   .on_line\@
        muls.l  d5,d1:d0
        nearest d1,d0
        add.l   d0,d3
.on_line\@
        ifnb    \3
        move.l  \3,d0
        bmi.s   .steep\@
        add.l   edge_lines(a0),d0
        lsr.l   #1,d0
        add.l   d0,d3
.steep\@
        endc
        move.l  d3,edge_\1(a0)
        moveq   #0,d0
        moveq   #1,d1
        cmp.l   edge_lines(a0),d1
        beq.s   .one\@                  ; else it is more than one line high: no overflow
        swap    d2
        move.l  d2,d0
        move.w  d2,d1
        ext.l   d1
        clr.w   d0
        nearest d1,d0
.one\@  move.l  d0,edge_d\1(a0)
        endm

; Finds the start and steps of the edge a0; \1, \2: by what u and v are raised. Uses d0-d7/a1-a2.
edge    macro
        movem.l edge_upper(a0),a1-a2    ; and lower
        move.l  vertex_y(a1),d0
        move.l  vertex_y(a2),d4
        sub.l   d0,d4
        move.l  edge_top(a0),d5
        swap    d5
        clr.w   d5
        sub.l   d0,d5
        move.l  d4,d7
        lsr.l   #1,d7
        moveq   #0,d6
        along   u,s,\1
        along   v,t,\2
        endm

; texturing_along - u and v where an edge crosses its lines
;
; in:      a0  edge*  as edges_make fills it
; reads:   lines, top, upper, lower of the edge; y, s, t of these two
; writes:  u, v, du, dv of the edge
; formats: 16.16, each to the nearest unit; du and dv are 0 if the edge has one line
; error:   n lines below the first: (n + 1) / 2^17 texels
; cost:    about 500 cycles, 300 if the upper end is on a line
        routine texturing_along,a0
        movem.l d2-d7/a2,-(sp)
        edge
        movem.l (sp)+,d2-d7/a2
        rts

; Raises \1 of the edge a0 and its step to multiples of 1 << their cut. Uses d0-d2.
cut     macro
        move.l  texturing_\1_cut(a3),d2
        beq.s   .whole\@
        moveq   #1,d0
        lsl.l   d2,d0
        subq.l  #1,d0
        move.l  edge_\1(a0),d1
        add.l   d0,d1
        lsr.l   d2,d1
        lsl.l   d2,d1
        move.l  d1,edge_\1(a0)
        add.l   edge_d\1(a0),d0
        lsr.l   d2,d0
        lsl.l   d2,d0
        move.l  d0,edge_d\1(a0)
.whole\@
        endm

; \2 = twice what starts fall short by with the step d\1dx, without their lines; -1 if it is too
; steep. d3 = width + 1. Uses d0-d2.
short   macro
        move.l  texturing_d\1dx(a3),d0
        minus   <neg.l d0>
        clr.w   d0
        swap    d0
        addq.l  #2,d0                   ; whole texels
        cmp.l   #STEEP_256,d0
        bls.s   .gentle\@
        moveq   #-1,d0
        bra.s   .short\@
.gentle\@
        addq.l  #1,d0
        lsl.l   #3,d0
        add.l   d3,d0
        move.l  texturing_\1_cut(a3),d1
        beq.s   .short\@
        move.l  d3,d2
        lsl.l   d1,d2
        add.l   d2,d0
.short\@
        movea.l d0,\2
        endm

STEEP_256       equ     256

; texturing_edges - u and v where left edges cross their lines, raised by what they may fall short
;
; in:      a0  texturing*  as texturing_longest fills it
;          a1  edge*       the edges, as edges_make fills them
;          d0  int32       how many, 1 or more
;          d1  int32       the pixels of the longest line
; reads:   *texturing; lines, top, upper, lower of the edges; y, s, t of their vertices
; writes:  u, v, du, dv of the edges
; formats: as texturing_along; with w = the step's whole texels, cut away, and 2: u is raised by
;          4 w + 4 + (lines + (pixels + 1) c) / 2 units, c being 1, or 1 + 2^cut where the span
;          does not keep cut low bits; nothing if w is above STEEP_256. Then it and its step are
;          raised to multiples of 1 << cut units
; error:   as texturing_along; raised as stated
; cost:    about 600 cycles an edge, 400 if its upper end is on a line
        routine texturing_edges,a0,a1,d0,d1
        save_all
        jsr     crossings_find
        return_all

; crossings_find - the same for assembly
;
; like:    texturing_edges
; trashes: d0-d7/a0-a6
; cost:    80 cycles less than texturing_edges
        routine crossings_find
        movea.l a0,a3
        movea.l a1,a0
        movea.l d0,a6
        move.l  d1,d3
        addq.l  #1,d3
        short   u,a4
        short   v,a5
.edge   edge    a4,a5
        cut     u
        cut     v
        move.l  texturing_wrap_bit(a3),d0
        beq.s   .free
        or.l    d0,edge_u(a0)
.free   lea     edge_sizeof(a0),a0
        subq.l  #1,a6
        move.l  a6,d0
        bne     .edge
        rts
