; Vertices of polygons as struct snapped_vertex. a1 the vertex, a2 the one it becomes, a4 the map's scale
; or 0 for 1, d2 the bits that any y so far has in 12.4, d3 SNAPPED_TEXELS << 16, d4 SNAPPED_HALF, d6 and d7 the
; largest x and y, 16.16, before they are rounded down. Uses d0/d1/d5. \1_out is where a vertex out of
; range goes.

; The largest x and y from the plan, where they are in 1/16 pixel.
vertices_begin macro
        move.l  #SNAPPED_TEXELS<<16,d3
        move.l  #SNAPPED_HALF,d4
        moveq   #16-SNAPPED_BITS,d0
        addq.l  #1,d6
        addq.l  #1,d7
        lsl.l   d0,d6
        lsl.l   d0,d7
        endm

; x and y.
vertex_place macro
        move.l  (a1),d0
        add.l   d4,d0
        cmp.l   d6,d0
        bhs     \1_out
        move.l  vertex_y(a1),d1
        add.l   d4,d1
        cmp.l   d7,d1
        bhs     \1_out
        lsl.l   #SNAPPED_BITS,d0
        lsl.l   #SNAPPED_BITS,d1
        swap    d1
        or.w    d1,d2
        move.w  d1,d0
        add.l   #SNAPPED_ONE<<16|SNAPPED_ONE-1,d0
        move.l  d0,(a2)
        endm

; The routine that multiplies s and t, d0 and d1, by the map's scale a4, to the nearest. Uses d5.
texels_scale macro
vertices_scale
        scaled  d0
        move.l  a4,d5
        scaled  d1
        rts
        endm

scaled  macro
        muls.l  d5,d5:\1
        add.l   #$8000,\1
        bcc.s   .half\@
        addq.w  #1,d5
.half\@ move.w  d5,\1
        swap    \1
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

; What enum vertex_values names.
none_values macro
        endm

shades_values macro
        move.l  vertex_shade(a1),d0
        keep_whole
        add.l   #SNAPPED_RAISED,d0
        lsl.l   #4,d0
        move.l  d0,snapped_vertex_u(a2)
        endm

; s and t.
texels_values macro
        move.l  vertex_s(a1),d0
        move.l  vertex_t(a1),d1
        move.l  a4,d5
        beq.s   .whole\@
        bsr     vertices_scale
.whole\@
        add.l   d3,d0
        add.l   d3,d1
        move.l  d0,d5
        or.l    d1,d5
        cmp.l   #SNAPPED_TEXELS<<17,d5
        bhs     \1_out
        add.l   #SNAPPED_RAISED-(SNAPPED_TEXELS<<16),d0
        add.l   #SNAPPED_RAISED-(SNAPPED_TEXELS<<16),d1
        lsl.l   #4,d0
        lsl.l   #4,d1
        move.l  d0,snapped_vertex_u(a2)
        move.l  d1,snapped_vertex_v(a2)
        endm

levels_values macro
        texels_values \1
        move.l  vertex_shade(a1),d0
        asr.l   #LEVEL_BITS-16,d0
        keep_whole
        lsl.l   #4,d0
        move.l  d0,snapped_vertex_level(a2)
        endm

level_values macro
        levels_values \1
        endm
