; Vertices of polygons as struct snapped_vertex. a1 the vertex, a2 the one it becomes, a4 the map's scale
; or 0 for 1, d2 and d3 least and greatest y so far, d4 SNAPPED_HALF, d5 the bits that snapping drops, d6 and d7
; the largest x and y. Uses d0/d1. \1_out, or \3, is where a vertex out of range goes.

; x and y.
vertex_place macro
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
        bge.s   .least\@
        move.w  d1,d2
.least\@
        cmp.w   d3,d1
        ble.s   .greatest\@
        move.w  d1,d3
.greatest\@
        add.w   #SNAPPED_ONE,d0
        swap    d0
        move.w  d1,d0
        add.w   #SNAPPED_ONE-1,d0
        move.l  d0,(a2)
        endm

; s or t at \1 as u or v at \2.
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
        bhs     \3_out
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

level_values macro
        levels_values \1
        endm
