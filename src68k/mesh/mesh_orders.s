        include "routine.i"

; mesh_orders - orders and corners of faces of a mesh with places
;
; in:      a0  const struct orders_plan*  count is 1 at least
; reads:   the plan, its mesh_placed, count entries' faces, these' corners and places
; writes:  order, a, b, c and d of count entries; a is 0 where mesh_link must stop: at a face with more
;          than TRIANGLE_CORNERS_MAX corners, of SNAPPED_LINES lines or more, or with a point that is
;          out of range
; formats: order: the greatest depth, 0 at least, shifted to the left and inverted
; cost:    bench rows mesh_orders and mesh_orders_quads: a face of three, of four corners

; a0 the face's corners, a1 the entry, a3 the instance's corners, a4 where the next corner is written,
; a5 the places; d2 the greatest depth, d3 all places, ored; d4 the bits that are clear there if the
; face is in range and cannot be too high; d5 entries left, d6 depth_shift, d7 corners left.

; Takes the corner \1 behind a0; a2 = its place. Uses d0/d1.
corner  macro
        move.w  \1*scene_corner_sizeof(a0),d0   ; scene_corner_point, below MESH_COUNT_MAX
        add.w   d0,d0
        lea     (a5,d0.w*8),a2          ; mesh_place_sizeof
        or.l    (a2),d3
        move.l  mesh_place_depth(a2),d1
        cmp.l   d1,d2
        bge.s   .nearer\@
        move.l  d1,d2
.nearer\@
        endm

        routine mesh_orders,a0
        save_all
        movea.l orders_plan_placed(a0),a1
        movea.l mesh_placed_corners(a1),a3
        movea.l mesh_placed_places(a1),a5
        movea.l orders_plan_faces(a0),a1
        move.l  orders_plan_count(a0),d5
        move.l  orders_plan_depth_shift(a0),d6
        move.l  #$80010000-SNAPPED_LINES*SNAPPED_ONE,d4
.face   movea.l mesh_face_face(a1),a0
        moveq   #-3,d7
        add.l   scene_face_corners(a0),d7
        move.l  scene_face_corner(a0),d0
        lea     (a3,d0.l*8),a0
        lea     (a0,d0.l*4),a0          ; scene_corner_sizeof
        lea     mesh_face_a(a1),a4
        moveq   #0,d2
        moveq   #0,d3
        corner  0
        move.l  a2,(a4)+
        corner  1
        move.l  a2,(a4)+
        corner  2
        move.l  a2,(a4)+
        tst.l   d7
        bne.s   .more
        move.l  d7,(a4)
.found  and.l   d4,d3
        bne.s   .look
.order  lsl.l   d6,d2
        not.l   d2
        move.l  d2,(a1)                 ; mesh_face_order
        lea     mesh_face_sizeof(a1),a1
        subq.l  #1,d5
        bne     .face
        return_all

.more   corner  3
        move.l  a2,(a4)
        subq.l  #1,d7
        beq.s   .found
.rest   lea     scene_corner_sizeof(a0),a0
        corner  3
        subq.l  #1,d7
        bne.s   .rest
        bra.s   .refuse

; The least and the greatest y.
.look   bmi.s   .refuse
        lea     mesh_face_a(a1),a4
        move.w  #$7fff,d0
        moveq   #0,d1
        moveq   #TRIANGLE_CORNERS_MAX-1,d7
.y      move.l  (a4)+,d3
        beq.s   .height
        movea.l d3,a2
        move.w  mesh_place_place+2(a2),d3
        cmp.w   d0,d3
        bge.s   .below
        move.w  d3,d0
.below  cmp.w   d1,d3
        ble.s   .above
        move.w  d3,d1
.above  dbra    d7,.y
.height sub.w   d0,d1
        cmp.w   #SNAPPED_LINES*SNAPPED_ONE,d1
        blo     .order
.refuse clr.l   mesh_face_a(a1)
        bra     .order
