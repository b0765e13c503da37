        include "routine.i"

        xref    triangle_outline,shade_vertices
        xref    texturing_far,_kind_spans,_three_longest,_three_rest,_three_starts

; three_draw - draws a triangle by the plan of its material
;
; in:      a0  three*   the plan
;          a1  vertex*  the three vertices, as material_vertices makes them
; out:     d0  int32    enum polygon_result
; reads:   the plan, the vertices, the map
; writes:  the plan's setup, scratch memory; pixels
; formats: those of triangle_outline and of the spans
; error:   theirs
; cost:    about 5,000 cycles for 8 textured pixels, 46,500 for 2,000
        routine three_draw,a0,a1
        save_all
        movea.l a0,a6
        movea.l a1,a2
        jsr     three_one
        return_all

; three_run - draws a run of triangles by the plan of their material
;
; in:      a0  three*    the plan
;          a1  polygon*  the first polygon
;          d0  polygon*  behind the last one
; out:     d0  polygon*  the first that was not drawn: one of more vertices, with three equal shades if
;                        vertices are shaded, or that three_draw refuses; or behind the last
; reads:   the plan, the polygons, the map
; writes:  as three_draw
; formats: as three_draw
; error:   as three_draw
; cost:    50 cycles a polygon more than three_draw
        routine three_run,a0,a1,d0
        save_all
        movea.l a0,a6
        movem.l d0/a1,-(sp)
.next   movea.l 4(sp),a0
        cmpa.l  (sp),a0
        beq.s   .end
        moveq   #3,d0
        cmp.l   polygon_count(a0),d0
        bne.s   .end
        movea.l polygon_vertices(a0),a2
        lea     polygon_sizeof(a0),a0
        move.l  a0,4(sp)
        move.l  three_vertices(a6),d0
        bne.s   .make
.made   jsr     three_one
        subq.l  #POLYGON_EMPTY,d0
        ble     .next
.back   moveq   #-polygon_sizeof,d0
        add.l   d0,4(sp)
.end    addq.l  #4,sp
        movea.l (sp)+,a0
        move.l  a0,d0                   ; where GCC expects a pointer, a0 is too
        return_all
.make   movea.l a2,a1
        movea.l setup_scratch(a6),a2
        adda.l  #scratch_vertices,a2
        movea.l a2,a0
        move.l  three_mask(a6),d1
        subq.l  #THREE_SHADED,d0
        beq.s   .shades
        moveq   #2,d0
.vertex movem.l (a1),d2-d5
        and.l   d1,d2
        and.l   d1,d3
        movem.l d2-d5,(a0)
        lea     vertex_sizeof(a1),a1
        lea     vertex_sizeof(a0),a0
        dbra    d0,.vertex
        bra     .made
.shades move.w  vertex_shade(a1),d0
        cmp.w   vertex_sizeof+vertex_shade(a1),d0
        bne.s   .differ
        cmp.w   2*vertex_sizeof+vertex_shade(a1),d0
        beq     .back
.differ moveq   #3,d0
        move.l  a2,-(sp)
        jsr     shade_vertices
        movea.l (sp)+,a2
        bra     .made

; three_one - draws a triangle by the plan of its material
;
; in:      a6  three*   the plan
;          a2  vertex*  the three vertices
; out:     d0  int32    enum polygon_result
; trashes: d1-d7/a0-a5
; reads:   as three_draw
; writes:  as three_draw
; formats: as three_draw
; error:   as three_draw
; cost:    as three_draw

        routine three_one
        move.l  a2,setup_vertices(a6)
        clr.l   setup_texturing+texturing_u_cut(a6)
        movem.l three_chain(a6),d1/a5   ; and edges
        jsr     triangle_outline
        tst.l   d0
        bne     .done

        movem.l setup_box(a6),d4-d7
        sub.l   d5,d7
        move.l  d7,setup_span+span_plan_count(a6)
        muls.w  setup_span+span_plan_pitch+2(a6),d5     ; it fits: three_set
        add.l   three_row(a6),d5
        move.l  d5,setup_span+span_plan_row(a6)
        sub.l   d4,d6                   ; width
        move.l  three_way(a6),d2
        beq.s   .steps
        move.l  three_starts(a6),d0
        bne     .starts
.planes movem.l setup_texturing+texturing_dudx(a6),d0-d1        ; and dvdx
        movem.l d0-d1,setup_span+span_plan_dudx(a6)
        movem.l d0-d1,setup_edges+edge_plan_dudx(a6)
.steps  tst.l   setup_sides+sides_x_low(a6)
        bmi     .rest
        move.l  setup_sides+sides_x_high(a6),d3
        add.l   #EDGE_ERROR,d3
        cmp.l   three_right(a6),d3
        bhi     .rest
        subq.w  #THREE_TEXELS,d2
        bne.s   .other
        lsl.l   #8,d0
        beq     .rest                   ; still: a row or a column
        lsl.l   #8,d1
        beq     .rest
        moveq   #SPAN_AFFINE_ADDX,d3
        tst.l   setup_texturing+texturing_wraps(a6)
        bne.s   .wraps
        moveq   #SHORT_AFFINE,d0
        cmp.l   d0,d6
        bgt.s   .lines
        moveq   #SPAN_AFFINE_SHORT,d3
        bra.s   .lines
.wraps  moveq   #SPAN_AFFINE_ADDX_WRAP,d3
        moveq   #SHORT_AFFINE_WRAP,d0
        cmp.l   d0,d6
        bgt.s   .lines
        moveq   #SPAN_AFFINE_SHORT_WRAP,d3
        bra.s   .lines
.other  subq.w  #THREE_REST-THREE_TEXELS,d2
        beq     .rest
        addq.w  #THREE_REST-THREE_SHADES,d2
        bgt.s   .wide
        bmi.s   .colour
        tst.l   d0
        minus   <neg.l d0>
        cmp.l   three_steep(a6),d0
        bhs     .rest
        moveq   #SPAN_GOURAUD,d3
        moveq   #SHORT_GOURAUD,d0
        cmp.l   d0,d6
        bgt.s   .lines
        moveq   #SPAN_GOURAUD_SHORT,d3
        bra.s   .lines
.wide   lsl.l   #8,d1
        beq     .rest
        move.l  setup_kind(a6),d3
        tst.l   setup_texturing+texturing_wraps(a6)
        bne.s   .lines
        subq.l  #SPAN_AFFINE_16_WRAP-SPAN_AFFINE_16,d3  ; as of 32 bits
        bra.s   .lines
.colour move.l  setup_kind(a6),d3

.lines  movem.l d3/a6,-(sp)
        lea     setup_edges(a6),a0
        movea.l three_lines(a6),a1
        jsr     (a1)
        movem.l (sp),d3/a6
        lea     _kind_spans,a0
        movea.l (a0,d3.w*4),a1
        lea     setup_span(a6),a0
        jsr     SPAN_SAVED(a1)
        addq.l  #4,sp
        movea.l (sp)+,a6
.drawn  moveq   #POLYGON_DRAWN,d0
.done   rts
.starts subq.l  #THREE_LONGEST,d0
        bne.s   .chosen
        movem.l d2/d6/a6,-(sp)
        movea.l a6,a0
        jsr     _three_longest
        movem.l (sp)+,d2/d6/a6
        movem.l setup_texturing+texturing_dudx(a6),d0-d1
        movem.l d0-d1,setup_span+span_plan_dudx(a6)
        bra     .steps
.chosen subq.l  #THREE_STARTS-THREE_LONGEST,d0
        bne.s   .whole
        move.l  a6,-(sp)
        jsr     _three_starts
        addq.l  #4,sp
        movem.l setup_texturing+texturing_dudx(a6),d0-d1
        bra     .steps
.whole  moveq   #CHAIN_WHOLE,d1
        jsr     texturing_far
        bra     .planes
.rest   move.l  a6,-(sp)
        jsr     _three_rest
        addq.l  #4,sp
        bra     .drawn
