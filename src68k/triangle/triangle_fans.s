        include "routine.i"
        include "vertices.i"

; triangle_fans - polygons of a material become triangles of a batch, as fans from their first vertices
;
; in:      a0  struct fans_plan*  its free, last and is_odd are set here
; out:     d0  const struct polygon*  the first one that was not taken, or the plan's end
; reads:   the plan, polygons, x, y and what the plan's values name of their vertices
; writes:  vertices; triangles; free and last, behind those of the polygons that were taken; is_odd
; formats: as triangle_vertices
; error:   as triangle_vertices
; cost:    350 to 860 cycles a polygon, by the mapper
;
; With `skips` it leaves out polygons that are wholly beyond one side of the frame, with s, t, x and y in
; range, as the rule OUTSIDE does. It stops with is_odd = 0 at a polygon of another number of corners than 3 and 4, with a vertex out of
; range, or of SNAPPED_LINES lines or more; with is_odd = 1 at one whose vertices it has converted, but which a
; cheaper kind may draw: with equal shades or levels, a level of 0 or LIGHT_LEVELS - 1, or the same u or v at the
; ends of a level edge. With `judged`, all are such.

; a3 the polygon, a5 the triangle, a6 the polygon's last vertex; the others as in vertices.i.

none_test macro
        endm

; Equal whole shades, or those that the mask \2 leaves.
shades_test macro
        movea.l polygon_vertices(a3),a1
        move.w  vertex_shade(a1),d0
        move.w  vertex_sizeof+vertex_shade(a1),d1
        eor.w   d0,d1
        ifnb    \2
        and.w   #\2,d1
        endc
        bne.s   \1_taken
        move.w  2*vertex_sizeof+vertex_shade(a1),d1
        eor.w   d0,d1
        ifnb    \2
        and.w   #\2,d1
        endc
        bne.s   \1_taken
        cmpi.l  #3,polygon_count(a3)
        beq     fans_odd
        move.w  3*vertex_sizeof+vertex_shade(a1),d1
        eor.w   d0,d1
        ifnb    \2
        and.w   #\2,d1
        endc
        beq     fans_odd
        endm

levels_test macro
        shades_test \1,-4
        endm

level_test macro
        movea.l polygon_vertices(a3),a1
        moveq   #-4,d0
        and.w   vertex_shade(a1),d0
        beq     fans_odd
        cmp.w   #4*LIGHT_LEVELS-4,d0
        beq     fans_odd
        endm

texels_test macro
        movea.l fans_plan_free(a0),a1
        move.w  snapped_vertex_y(a1),d0
        move.w  snapped_vertex_sizeof+snapped_vertex_y(a1),d1
        cmp.w   d1,d0
        beq     fans_level
        cmp.w   2*snapped_vertex_sizeof+snapped_vertex_y(a1),d1
        beq     fans_level
        move.w  snapped_vertex_y-snapped_vertex_sizeof(a2),d1
        cmp.w   d1,d0
        beq     fans_level
        cmpi.l  #3,polygon_count(a3)
        beq.s   texels_taken
        cmp.w   2*snapped_vertex_sizeof+snapped_vertex_y(a1),d1
        beq     fans_level
        endm

; The polygons with \1_values.
fans    macro
\1_polygon
        cmpa.l  fans_plan_end(a0),a3
        beq     fans_done
        movea.l polygon_vertices(a3),a1
        lea     3*snapped_vertex_sizeof(a2),a6
        move.l  polygon_count(a3),d0
        subq.l  #3,d0
        beq.s   \1_begin
        subq.l  #1,d0
        bne     fans_many
        lea     snapped_vertex_sizeof(a6),a6
\1_begin
        moveq   #0,d2
\1_vertex
        vertex_place fans
        \1_values fans
        lea     vertex_sizeof(a1),a1
        lea     snapped_vertex_sizeof(a2),a2
        cmpa.l  a6,a2
        bne     \1_vertex
        cmp.w   #SNAPPED_LINES*SNAPPED_ONE,d2
        bcs.s   \1_low
        bsr     fans_tall
        bge     fans_done
\1_low
        tst.l   fans_plan_judged(a0)
        bne     fans_odd
        \1_test \1
\1_taken
        movea.l fans_plan_free(a0),a1
        lea     snapped_vertex_sizeof(a1),a6
\1_fan  move.l  a1,(a5)+
        move.l  a6,(a5)+
        lea     snapped_vertex_sizeof(a6),a6
        move.l  a6,(a5)+
        moveq   #snapped_vertex_sizeof,d0
        add.l   a6,d0
        cmp.l   a2,d0
        bne.s   \1_fan
        move.l  a2,fans_plan_free(a0)
        lea     polygon_sizeof(a3),a3
        bra     \1_polygon
        endm

        routine triangle_fans,a0
        save_all
        clr.l   fans_plan_is_odd(a0)
        movem.l fans_plan_right(a0),d6-d7/a2-a5
        move.l  a2,fans_plan_free(a0)
        vertices_begin
fans_next
        move.l  fans_plan_values(a0),d0
        beq     none_polygon
        subq.l  #VALUES_TEXELS,d0
        blo     shades_polygon
        beq     texels_polygon
        subq.l  #VALUES_LEVEL-VALUES_TEXELS,d0
        beq     level_polygon
        fans    levels
        fans    level
        fans    texels
        fans    shades
        fans    none
        texels_scale
; A polygon with texels a1 that has a level edge. a6 the vertex before a1.
fans_level
        lea     -snapped_vertex_sizeof(a2),a6
.edge   move.w  snapped_vertex_y(a1),d0
        cmp.w   snapped_vertex_y(a6),d0
        bne.s   .next
        move.l  snapped_vertex_u(a1),d0
        cmp.l   snapped_vertex_u(a6),d0
        beq     fans_odd
        move.l  snapped_vertex_v(a1),d0
        cmp.l   snapped_vertex_v(a6),d0
        beq     fans_odd
.next   movea.l a1,a6
        lea     snapped_vertex_sizeof(a1),a1
        cmpa.l  a2,a1
        bne.s   .edge
        bra     texels_taken

; Compares a polygon's height with SNAPPED_LINES. Uses d0-d2/a1.
fans_tall
        movea.l fans_plan_free(a0),a1
        move.w  snapped_vertex_y(a1),d0
        move.w  d0,d1
.vertex lea     snapped_vertex_sizeof(a1),a1
        cmpa.l  a2,a1
        beq.s   .range
        move.w  snapped_vertex_y(a1),d2
        cmp.w   d2,d0
        ble.s   .not_least
        move.w  d2,d0
.not_least
        cmp.w   d2,d1
        bge.s   .vertex
        move.w  d2,d1
        bra.s   .vertex
.range  sub.w   d0,d1
        cmp.w   #SNAPPED_LINES*SNAPPED_ONE,d1
        rts
; The vertices \1 of the polygon a3 against the limit d0: goes to \3 at the first with the condition \2.
fans_side macro
        movea.l polygon_vertices(a3),a1
        move.l  polygon_count(a3),d1
.vertex\@
        cmp.l   \1(a1),d0
        \2     \3
        lea     vertex_sizeof(a1),a1
        subq.l  #1,d1
        bne.s   .vertex\@
        endm

; Another number of corners: d0 more than four.
fans_many
        cmp.l   #POLYGON_VERTICES_MAX-TRIANGLE_CORNERS_MAX,d0
        bhi     fans_done

; The vertex a1 may be out of range.
fans_out
        tst.l   fans_plan_skips(a0)
        beq     fans_done
        move.l  vertex_y(a1),d5
        move.l  fans_plan_beyond_x(a0),d0
        cmp.l   (a1),d0
        ble.s   .right
        moveq   #-1,d0
        swap    d0
        clr.w   d0                      ; -1 pixel
        cmp.l   (a1),d0
        ble.s   .y
        fans_side 0,ble.s,.y
        bra.s   .range
.right  fans_side 0,bgt.s,.y
        bra.s   .range
.y      move.l  fans_plan_beyond_y(a0),d0
        cmp.l   d5,d0
        ble.s   .below
        moveq   #-1,d0
        swap    d0
        clr.w   d0
        cmp.l   d5,d0
        ble     fans_done
        fans_side vertex_y,ble,fans_done
        bra.s   .range
.below  fans_side vertex_y,bgt,fans_done
.range  movea.l polygon_vertices(a3),a1
        move.l  polygon_count(a3),d1
        move.l  #POLYGON_FAR<<16,d0
        moveq   #0,d5
.vertex rept    4
        move.l  (a1)+,d2
        add.l   d0,d2
        or.l    d2,d5
        endr
        addq.l  #vertex_sizeof-16,a1
        subq.l  #1,d1
        bne.s   .vertex
        tst.l   d5
        bmi.s   fans_done
        movea.l fans_plan_free(a0),a2
        lea     polygon_sizeof(a3),a3
        bra     fans_next
fans_odd
        addq.l  #1,fans_plan_is_odd(a0)
fans_done
        move.l  a5,fans_plan_last(a0)
        move.l  a3,d0
        movea.l d0,a0                   ; where GCC expects a pointer
        return_all
