        include "routine.i"

; mesh_vertices - a face's corners as vertices, from points that were transformed with 32-bit operands
;
; in:      a0  const struct mesh_face*  its instance is not linked to places
;          a1  struct vertex*  of as many as the face has corners
; out:     d0  uint32  the borders, enum mesh_outside, that a point is outside of
; reads:   the face, its instance, corners, their points, attributes of their normals if flags say so
; writes:  the vertices: x and y on the screen if all points are inside all borders, else in the camera's space
; formats: 16.16
; cost:    bench rows mesh_vertices and mesh_vertices_lit: four corners inside

; a0 the corner, a2 the attributes, a3 the face, a4 the points; d0 the borders, d6 flags, d7 corners left
        routine mesh_vertices,a0,a1
        movem.l d2-d7/a2-a5,-(sp)
        movea.l mesh_face_face(a0),a3
        movea.l mesh_face_placed(a0),a5
        movea.l mesh_placed_points(a5),a4
        move.l  scene_face_corner(a3),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        movea.l mesh_placed_corners(a5),a0
        lea     (a0,d0.l*4),a0          ; scene_corner_sizeof
        move.l  scene_face_corners(a3),d7
        movem.l d7/a0-a1,-(sp)
        moveq   #0,d0
        move.l  mesh_placed_flags(a5),d6
        bne.s   .look
.corner moveq   #0,d1
        move.w  (a0),d1                 ; scene_corner_point
        lsl.l   #5,d1                   ; mesh_point_sizeof
        lea     mesh_point_w(a4,d1.l),a3
        movem.l (a3),d2-d5              ; w, screen_x, screen_y, outside
        or.l    d5,d0
        move.l  d3,(a1)+
        move.l  d4,(a1)+
        addq.l  #4,a0
        move.l  (a0)+,(a1)+
        move.l  (a0)+,(a1)+
        clr.l   (a1)+
        move.l  d2,(a1)+
        subq.l  #1,d7
        bne.s   .corner
.made   tst.l   d0
        bne.s   .outside
.done   lea     12(sp),sp
        movem.l (sp)+,d2-d7/a2-a5
        rts

.look   movea.l mesh_placed_attributes(a5),a2
.value  moveq   #0,d1
        move.w  (a0)+,d1
        lsl.l   #5,d1
        lea     mesh_point_w(a4,d1.l),a3
        movem.l (a3),d2-d5
        or.l    d5,d0
        move.l  d3,(a1)+
        move.l  d4,(a1)+
        moveq   #0,d1
        move.w  (a0)+,d1                ; scene_corner_normal
        lsl.l   #4,d1                   ; mesh_attributes_sizeof
        lea     (a2,d1.l),a3
        btst    #0,d6                   ; MESH_ENVIRONMENT
        bne.s   .environment
        move.l  (a0)+,(a1)+
        move.l  (a0)+,(a1)+
.shade  moveq   #0,d1
        btst    #1,d6                   ; MESH_LIT
        beq.s   .unlit
        move.l  mesh_attributes_shade(a3),d1
.unlit  move.l  d1,(a1)+
        move.l  d2,(a1)+
        subq.l  #1,d7
        bne.s   .value
        bra.s   .made
.environment
        addq.l  #8,a0
        move.l  mesh_attributes_s(a3),(a1)+
        move.l  mesh_attributes_t(a3),(a1)+
        bra.s   .shade

; Again: x and y in the camera's space.
.outside
        movem.l (sp),d7/a0-a1
.camera moveq   #0,d1
        move.w  (a0),d1                 ; scene_corner_point
        lsl.l   #5,d1
        lea     (a4,d1.l),a3
        move.l  (a3)+,(a1)+             ; mesh_point_x, mesh_point_y
        move.l  (a3),(a1)
        lea     scene_corner_sizeof(a0),a0
        lea     vertex_sizeof-4(a1),a1
        subq.l  #1,d7
        bne.s   .camera
        bra.s   .done
