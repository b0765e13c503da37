        include "routine.i"

; triangle_vertices - vertices of polygons become those of triangles that are set up in 32 bits
;
; in:      a0  const struct vertices_plan*  the count may be 0
; out:     d0  int32  1 if all are in range and cover fewer than SNAPPED_LINES lines, else 0
; reads:   the plan; x and y of count vertices from `from` on; s and t with VALUES_TEXELS and
;          VALUES_LEVELS, shade with VALUES_SHADES and VALUES_LEVELS
; writes:  count vertices from `to` on: x and y; u and v with VALUES_TEXELS and VALUES_LEVELS, u with
;          VALUES_SHADES, level with VALUES_LEVELS. One out of range gets -1 as x and y, and any values
; formats: 16.16; x and y to 12.4, others to 12.20
; error:   x and y 1/32 pixel; u and v half of 1/65536 texel if the plan has a scale, else none
; cost:    bench rows triangle_vertices

; a1 the vertex, a2 the one it becomes, a3 the first one's end, a4 the scale, d2 and d3 least and greatest
; y, d4 half of 1/16 pixel, d6 and d7 the largest x and y.

; \1 as \2.
texel_value macro
        move.l  \1(a1),d0
        move.l  a4,d1
        beq.s   .whole\@
        muls.l  d1,d1:d0
        add.l   #$8000,d0               ; to the nearest
        bcc.s   .half\@
        addq.w  #1,d1
.half\@ move.w  d1,d0
        swap    d0
.whole\@
        add.l   #SNAPPED_TEXELS<<16,d0
        cmp.l   #SNAPPED_TEXELS<<17,d0
        bhs     \3
        add.l   #SNAPPED_RAISED-(SNAPPED_TEXELS<<16),d0
        lsl.l   #4,d0
        move.l  d0,\2(a2)
        endm

; Keeps d0 inside the range of its whole number: only the fraction is compared.
keep_whole macro
        cmp.w   #SHADE_INSET,d0
        bhs.s   .least\@
        move.w  #SHADE_INSET,d0
.least\@
        cmp.w   #-1-SHADE_INSET,d0
        bls.s   .greatest\@
        move.w  #-1-SHADE_INSET,d0
.greatest\@
        endm

none_values macro
        endm

shades_values macro
        move.l  vertex_shade(a1),d0
        keep_whole
        add.l   #SNAPPED_RAISED,d0
        lsl.l   #4,d0
        move.l  d0,snapped_vertex_u(a2)
        endm

texels_values macro
        texel_value vertex_s,snapped_vertex_u,\1
        texel_value vertex_t,snapped_vertex_v,\1
        endm

levels_values macro
        texels_values \1
        move.l  vertex_shade(a1),d0
        asr.l   #LEVEL_BITS-16,d0
        keep_whole
        lsl.l   #4,d0
        move.l  d0,snapped_vertex_level(a2)
        endm

; The vertices with \1_values.
vertices macro
\1_vertex
        move.l  (a1),d0
        add.l   d4,d0
        asr.l   d5,d0
        cmp.l   d6,d0
        bhi     \1_out
        move.l  vertex_y(a1),d1
        add.l   d4,d1
        asr.l   d5,d1
        cmp.l   d7,d1
        bhi     \1_out
        cmp.w   d2,d1
        bge.s   \1_low
        move.w  d1,d2
\1_low  cmp.w   d3,d1
        ble.s   \1_high
        move.w  d1,d3
\1_high add.w   #SNAPPED_ONE,d0
        swap    d0
        move.w  d1,d0
        add.w   #SNAPPED_ONE-1,d0
        move.l  d0,(a2)
        \1_values \1_out
\1_next lea     vertex_sizeof(a1),a1
        lea     snapped_vertex_sizeof(a2),a2
        cmpa.l  a3,a1
        bne     \1_vertex
        bra     vertices_done
\1_out  moveq   #-1,d0
        move.l  d0,(a2)
        moveq   #0,d2                   ; more lines than any triangle may have
        move.w  #$7fff,d3
        bra     \1_next
        endm

        routine triangle_vertices,a0
        movem.l d2-d7/a2-a4,-(sp)
        movem.l vertices_plan_count(a0),d5-d7/a1-a2
        movea.l vertices_plan_scale(a0),a4
        move.l  #$7fff,d2
        moveq   #0,d3
        lsl.l   #3,d5
        beq     vertices_done
        lea     (a1,d5.l),a3
        lea     (a3,d5.l*2),a3          ; vertex_sizeof
        move.l  #SNAPPED_HALF,d4
        moveq   #16-SNAPPED_BITS,d5
        move.l  vertices_plan_values(a0),d0
        beq     none_vertex
        subq.l  #VALUES_TEXELS,d0
        blo     shades_vertex
        bhi     levels_vertex
        vertices texels
        vertices levels
        vertices shades
        vertices none
vertices_done
        sub.w   d2,d3
        moveq   #0,d0
        cmp.w   #SNAPPED_LINES*SNAPPED_ONE,d3
        bge.s   .not
        moveq   #1,d0
.not    movem.l (sp)+,d2-d7/a2-a4
        rts
