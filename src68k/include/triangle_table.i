; Triangles whose lines become a scanline table, for the spans that have no routine for triangles of
; their own. The geometry is that of wide triangles, with pixels for addresses: row 0 is at EDGE_BIAS,
; lines are 0 bytes apart.

        include "triangle_wide.i"

; Begins a routine with the batch a0; batch_source is the span plan.
table_open macro
        save_all
        lea     -batch_sizeof(sp),sp
        movea.l sp,a5
        move.l  triangle_plan_cull(a0),batch_cull(a5)
        move.l  triangle_plan_end(a0),batch_end(a5)
        move.l  #EDGE_BIAS,batch_row(a5)
        clr.l   batch_pitch(a5)
        move.l  triangle_plan_reciprocals(a0),batch_reciprocals(a5)
        move.l  triangle_plan_row(a0),batch_pixels(a5)
        move.l  triangle_plan_shade(a0),batch_shade(a5)
        movea.l triangle_plan_span(a0),a1
        move.l  a1,batch_source(a5)
        clr.l   span_plan_count(a1)
        movea.l triangle_plan_list(a0),a0
        bra     triangle_next
        endm

; Sets the span plan's row and its number of lines, which \1 bytes of stack are below: a1 = the table,
; a5 = the plan. a1: the top vertex, a5: the batch. Uses d0/d1.
table_begin macro
        moveq   #0,d0
        move.w  snapped_vertex_y(a1),d0
        move.l  batch_pixels(a5),d1
        movea.l batch_source(a5),a5
        lsr.w   #4,d0
        mulu.w  span_plan_pitch+2(a5),d0
        add.l   d1,d0
        move.l  d0,span_plan_row(a5)
        move.l  wide_count_1+\1(sp),d0
        add.l   wide_count_2+\1(sp),d0
        move.l  d0,span_plan_count(a5)
        movea.l span_plan_lines(a5),a1
        endm

; Sets triangles up with values of the mapper \1 until one has lines.
table_set_up macro
        triangle_fetch
        triangle_order .right
        wide_set_up left,\1
.right  exg     d1,d2
        exg     a2,a3
        wide_set_up right,\1
        endm

; Leaves the routine with the triangle behind the one that has lines.
table_close macro
table_end
        lea     wide_list(sp),sp
        movea.l (sp)+,a0
        bra     triangle_done
        endm
