        include "outline.i"

        xref    sides_find,edges_make,triangle_outline,texturing_gentle
        xref    edge_exact_across,edge_rounded_across

; polygon_outline - a polygon's sides, box, edges and, if it is textured, its plane
;
; in:      a6  setup*  the polygon; with a chain, the cuts of its texturing are set
;          d0  int32   1: exact edges, 0: rounded ones
;          d1  int32   enum chain; below 0: the plane is not found; below -1: edges only of three vertices, else
;                      lefts is 0
; out:     d0  int32   POLYGON_DRAWN; POLYGON_EMPTY: no pixel of the frame may be covered; or as
;                      sides_find
; trashes: d1-d7/a0-a5
; reads:   vertices, count and frame of the setup; left and right of its edges
; writes:  its sides, box, outline_sides; lefts and rights of its edges, and these; as
;          texturing_gentle
; formats: the box is the part of the frame that edges may cover, EDGE_ERROR being their error in x
; error:   that of the edges and of the plane
; cost:    that of triangle_outline for a triangle; about 3,000 cycles for four vertices with exact
;          edges and a cold cache; with its plane 5,000
        routine polygon_outline
        lea     setup_sides(a6),a0
        move.l  a0,setup_outline_sides(a6)
        moveq   #3,d2
        cmp.l   setup_count(a6),d2
        bne.s   .many
        movea.l setup_vertices(a6),a2
        lea     edge_exact_across,a5
        tst.l   d0
        bne.s   .exact
        lea     edge_rounded_across,a5
.exact  jmp     triangle_outline

.many   movem.l d0-d1,-(sp)
        movea.l setup_vertices(a6),a1
        move.l  setup_count(a6),d0
        jsr     sides_find
        tst.l   d0
        bne     .done

        lea     setup_sides(a6),a0
        movea.l setup_frame(a6),a3
        movem.l sides_x_low(a0),d0/d2   ; and x_high
        sub.l   #EDGE_ERROR,d0
        box_begin d0
        add.l   #EDGE_ERROR,d2
        box_end d2,frame_width(a3)
        cmp.l   d2,d0
        bge     .empty
        movem.l sides_top(a0),a1-a2     ; and bottom
        move.l  vertex_y(a1),d1
        box_begin d1
        move.l  vertex_y(a2),d3
        box_end d3,frame_height(a3)
        cmp.l   d3,d1
        bge     .empty
        lea     setup_box(a6),a4
        movem.l d0-d3,(a4)              ; left, top, right, bottom

        moveq   #-1,d2
        cmp.l   4(sp),d2
        bgt.s   .without
        movea.l a0,a1
        lea     setup_edges(a6),a0
        move.l  a4,d0
        move.l  (sp),d1
        jsr     edges_make
        addq.l  #4,sp
        move.l  (sp)+,d1
        bmi.s   .drawn
        jsr     texturing_gentle
.drawn  moveq   #POLYGON_DRAWN,d0
        rts
.without
        clr.l   setup_edges+edge_plan_lefts(a6)
        moveq   #POLYGON_DRAWN,d0
        bra.s   .done
.empty  moveq   #POLYGON_EMPTY,d0
.done   addq.l  #8,sp
        rts

; polygon_find - what polygon_outline finds
;
; in:      a0  setup*  the polygon
;          d0  int32   1: exact edges, 0: rounded ones
;          d1  int32   enum chain, or below 0
; out:     d0  int32   enum polygon_result
; reads:   as polygon_outline
; writes:  as polygon_outline
; cost:    as polygon_outline, and 150
        routine polygon_find,a0,d0,d1
        save_all
        movea.l a0,a6
        jsr     polygon_outline
        return_all

; plane_find - a polygon's plane, and u and v where its left edges begin
;
; in:      a0  setup*  a polygon with sides, box and edges; the cuts of its texturing are set
;          d0  int32   enum chain
; reads:   sides, box, texturing and edges of the setup
; writes:  its texturing; u, v, du, dv of its left edges, as texturing_gentle
; formats: theirs
; error:   theirs
; cost:    about 2,000 cycles with a cold cache and one left edge
        routine plane_find,a0,d0
        save_all
        movea.l a0,a6
        move.l  d0,d1
        jsr     texturing_gentle
        return_all
