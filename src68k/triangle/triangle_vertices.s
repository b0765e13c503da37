        include "routine.i"
        include "vertices.i"

; triangle_vertices - vertices of polygons become those of triangles that are set up in 32 bits
;
; in:      a0  const struct vertices_plan*  its count may be 0
; reads:   the plan; x and y of the vertices; s and t with VALUES_TEXELS, VALUES_LEVEL and VALUES_LEVELS, shade
;          with all but VALUES_TEXELS
; writes:  as many vertices: x and y; u and v, or u where the value is a shade; level with VALUES_LEVEL and
;          VALUES_LEVELS. One out of range gets -1 as x and y, and any values
; formats: 16.16; x and y to 12.4, others to 12.20
; error:   x and y 1/32 pixel; u and v half of 1/65536 texel if the plan has a scale, else none
; cost:    78 to 204 cycles a vertex, by the mapper

; The vertices up to a3 with \1_values.
vertices macro
\1_vertex
        vertex_place \1
        \1_values \1
\1_next lea     vertex_sizeof(a1),a1
        lea     snapped_vertex_sizeof(a2),a2
        cmpa.l  a3,a1
        bne     \1_vertex
        bra     vertices_done
\1_out  moveq   #-1,d0
        move.l  d0,(a2)
        bra     \1_next
        endm

        routine triangle_vertices,a0
        movem.l d2-d7/a2-a4,-(sp)
        movem.l vertices_plan_count(a0),d3/d6-d7/a1-a2/a4
        lsl.l   #3,d3
        beq     vertices_done
        lea     (a1,d3.l),a3
        lea     (a3,d3.l*2),a3          ; vertex_sizeof
        vertices_begin
        move.l  vertices_plan_values(a0),d0
        beq     none_vertex
        subq.l  #VALUES_TEXELS,d0
        blo     shades_vertex
        bhi     levels_vertex
        vertices texels
        vertices levels
        vertices shades
        vertices none
        texels_scale
vertices_done
        movem.l (sp)+,d2-d7/a2-a4
        rts
