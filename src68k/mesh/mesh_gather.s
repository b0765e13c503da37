        include "routine.i"

; mesh_gather - faces of a mesh become triangles of a batch, as fans from their first corners
;
; in:      a0  struct gather_plan*  its placed and corners are set here
; out:     d0  const struct mesh_face*  the first face that was not taken: the list or its room ends, the
;                                     material or the flags are others, it has more than
;                                     TRIANGLE_CORNERS_MAX corners or SNAPPED_LINES lines or more, or
;                                     a point, u or v is out of range
; reads:   the plan, faces, their corners, places, attributes of normals
; writes:  vertices; triangles; the plan's last, behind the last triangle
; formats: places as in struct mesh_place; s, t and shades 16.16; u, v, shades and levels of vertices
;          12.20
; error:   u and v half of 1/65536 texel if the map's scale is not 1, else none
; cost:    bench rows mesh_gather_flat, mesh_gather_gouraud, mesh_gather_affine

; a0 the plan, a1 the face, a2 its corner, a3 the vertex, a4 the triangle, a5 the places, a6 the
; attributes; d3 the face's first vertex, d4 corners left, d5 and d7 least and greatest y, d6 the
; map's scale, 0 for 1; in mirror_values SNAPPED_RAISED.

; s or t, \1, as u or v to the vertex. Uses d0/d2.
texels  macro
        move.l  \1,d2
        tst.l   d6
        beq.s   .whole\@
        muls.l  d6,d0:d2
        add.l   #$8000,d2               ; to the nearest
        bcc.s   .half\@
        addq.w  #1,d0
.half\@
        move.w  d0,d2
        swap    d2
.whole\@
        add.l   #SNAPPED_TEXELS<<16,d2
        cmp.l   #SNAPPED_TEXELS<<17,d2
        bhs     gather_done
        add.l   #SNAPPED_RAISED-(SNAPPED_TEXELS<<16),d2
        lsl.l   #4,d2
        move.l  d2,(a3)+
        endm

; The values of a corner, to the vertex. d1: its normal's attributes.
flat_values macro
        addq.l  #8,a2
        lea     12(a3),a3
        endm

; A shade or level is kept inside its whole one's range: two compares of its fraction.
inset   macro
        cmp.w   #SHADE_INSET,d2
        bhs.s   .least\@
        move.w  #SHADE_INSET,d2
.least\@
        cmp.w   #-1-SHADE_INSET,d2
        bls.s   .greatest\@
        move.w  #-1-SHADE_INSET,d2
.greatest\@
        endm

; The level of light, a quarter of the shade.
level_value macro
        move.l  mesh_attributes_shade(a6,d1.l),d2
        lsr.l   #LEVEL_BITS-16,d2
        inset
        lsl.l   #4,d2
        move.l  d2,(a3)+
        endm

gouraud_values macro
        addq.l  #8,a2
        move.l  mesh_attributes_shade(a6,d1.l),d2
        inset
        add.l   #SNAPPED_RAISED,d2
        lsl.l   #4,d2
        move.l  d2,(a3)+
        addq.l  #8,a3
        endm

affine_values macro
        texels  (a2)+
        texels  (a2)+
        addq.l  #4,a3
        endm

lit_values macro
        texels  (a2)+
        texels  (a2)+
        level_value
        endm

; An environment's s and t are 0 to 256: in range without a test if the scale is 1.
mirror_values macro
        addq.l  #8,a2
        move.l  mesh_attributes_s(a6,d1.l),d2
        add.l   d6,d2
        lsl.l   #4,d2
        move.l  d2,(a3)+
        move.l  mesh_attributes_t(a6,d1.l),d2
        add.l   d6,d2
        lsl.l   #4,d2
        move.l  d2,(a3)+
        addq.l  #4,a3
        endm

scaled_mirror_values macro
        addq.l  #8,a2
        texels  mesh_attributes_s(a6,d1.l)
        texels  mesh_attributes_t(a6,d1.l)
        addq.l  #4,a3
        endm

lit_mirror_values macro
        addq.l  #8,a2
        texels  mesh_attributes_s(a6,d1.l)
        texels  mesh_attributes_t(a6,d1.l)
        level_value
        endm

; The faces. \1: the macro for the values of a corner.
gather  macro
.face\@ move.l  a1,d0
        beq     gather_done
        cmpa.l  gather_plan_full(a0),a4
        bhi     gather_done
        move.l  mesh_face_placed(a1),d0
        cmp.l   gather_plan_placed(a0),d0
        bne     .other\@
.same\@ movea.l mesh_face_face(a1),a2
        move.l  scene_face_corners(a2),d4
        cmp.l   #TRIANGLE_CORNERS_MAX,d4
        bhi     gather_done
        move.l  scene_face_corner(a2),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        movea.l gather_plan_corners(a0),a2
        lea     (a2,d0.l*4),a2          ; scene_corner_sizeof
        move.l  a3,d3
        move.w  #$7fff,d5
        moveq   #0,d7
.corner\@
        move.w  (a2)+,d0                ; scene_corner_point, below MESH_COUNT_MAX
        add.w   d0,d0
        move.l  (a5,d0.w*8),d0          ; mesh_place_sizeof
        bmi     gather_done
        move.l  d0,(a3)+
        moveq   #0,d1
        move.w  (a2)+,d1                ; scene_corner_normal
        lsl.l   #4,d1                   ; mesh_attributes_sizeof
        cmp.w   d5,d0
        bge.s   .below\@
        move.w  d0,d5
.below\@
        cmp.w   d7,d0
        ble.s   .above\@
        move.w  d0,d7
.above\@
        \1
        subq.l  #1,d4
        bne     .corner\@
        sub.w   d5,d7
        cmp.w   #SNAPPED_LINES*SNAPPED_ONE,d7
        bhs     gather_done
        moveq   #snapped_vertex_sizeof,d1
        move.l  d3,d0
        add.l   d1,d0
.fan\@  move.l  d3,(a4)+
        move.l  d0,(a4)+
        add.l   d1,d0
        move.l  d0,(a4)+
        move.l  d0,d2
        add.l   d1,d2
        cmp.l   a3,d2
        blo.s   .fan\@
        movea.l mesh_face_next(a1),a1
        bra     .face\@
.other\@
        movea.l d0,a2
        move.l  mesh_placed_material(a2),d1
        cmp.l   gather_plan_material(a0),d1
        bne     gather_done
        move.l  mesh_placed_flags(a2),d1
        cmp.l   gather_plan_flags(a0),d1
        bne     gather_done
        move.l  d0,gather_plan_placed(a0)
        move.l  mesh_placed_corners(a2),gather_plan_corners(a0)
        movea.l mesh_placed_places(a2),a5
        movea.l mesh_placed_attributes(a2),a6
        bra     .same\@
        endm

        routine mesh_gather,a0
        save_all
        clr.l   gather_plan_placed(a0)
        movea.l gather_plan_from(a0),a1
        movea.l gather_plan_vertices(a0),a3
        movea.l gather_plan_list(a0),a4
        move.l  gather_plan_scale(a0),d6
        moveq   #MESH_ENVIRONMENT,d0
        and.l   gather_plan_flags(a0),d0
        move.l  gather_plan_values(a0),d1
        beq     .flat
        subq.l  #GATHER_SHADES,d1
        beq     .gouraud
        subq.l  #GATHER_LIT-GATHER_SHADES,d1
        beq     .lit
        tst.l   d0
        bne     .mirror
        gather  affine_values
.lit    tst.l   d0
        bne     .lit_mirror
        gather  lit_values
.lit_mirror
        gather  lit_mirror_values
.mirror tst.l   d6
        bne     .scaled_mirror
        move.l  #SNAPPED_RAISED,d6
        gather  mirror_values
.scaled_mirror
        gather  scaled_mirror_values
.flat   gather  flat_values
.gouraud
        gather  gouraud_values
gather_done
        move.l  a4,gather_plan_last(a0)
        move.l  a1,d0
        movea.l d0,a0                   ; where GCC expects a pointer
        return_all
