; How polygons in perspective that are drawn by the plan of their material begin.

        include "routine.i"

; The plan in a0 to a6; goes on with the outline of its polygon made, d1 = \1 (polygon_outline's). Where w is constant it
; goes to .constant, where there is no outline to .done, with d0 = enum polygon_result.
deep_outline macro
        movea.l a0,a6
        movea.l setup_vertices(a6),a0
        move.l  setup_count(a6),d1
        subq.w  #2,d1
        move.l  vertex_w(a0),d0
.vertex lea     vertex_sizeof(a0),a0
        cmp.l   vertex_w(a0),d0
        dbne    d1,.vertex
        beq     .constant
        move.l  deep_exact(a6),d0
        moveq   #\1,d1
        jsr     polygon_outline
        tst.l   d0
        bne     .done
        endm

; Sets the height, and the row of the first line in the frame; d5 top, d7 height.
deep_rows macro
        movem.l setup_box(a6),d4-d7
        sub.l   d5,d7
        move.l  d7,setup_span+span_plan_count(a6)
        muls.w  setup_span+span_plan_pitch+2(a6),d5     ; it fits: deep_begin
        add.l   deep_row(a6),d5
        move.l  d5,setup_span+span_plan_row(a6)
        endm
