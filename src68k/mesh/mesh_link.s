        include "routine.i"

; mesh_link - faces of a mesh become triangles of a batch whose vertices are the mesh's places
;
; in:      a0  struct gather_plan*  its vertices, values and scale are not used; its placed and corners
;                                   are not set
; out:     d0  const struct mesh_face*  the first face that was not taken
; reads:   the plan, faces, their corners, places
; writes:  triangles; the plan's last, behind the last triangle
; formats: places as in struct mesh_place; triangles are fans from the first corners
; cost:    bench rows mesh_link and mesh_link_quads: a face of three, of four corners
;
; It stops where mesh_gather does.

; a6 the plan, a1 the face, a2 its corner, a3 the instance's corners, a4 the triangle; a5 the places; d1 and d2 least and greatest y, d3 the first vertex, d5 the face's first triangle, d6 full,
; d7 the instance.

; a0 = the vertex of corner \1, which is added to the list. Uses d0.
vertex  macro
        move.w  \1*scene_corner_sizeof(a2),d0   ; scene_corner_point, below MESH_COUNT_MAX
        add.w   d0,d0
        lea     (a5,d0.w*8),a0          ; mesh_place_sizeof
        move.l  (a0),d0
        bmi     .refuse
        move.l  a0,(a4)+
        endm

; Widens least and greatest y by the last vertex's.
widen   macro
        cmp.w   d1,d0
        bge.s   .below\@
        move.w  d0,d1
.below\@
        cmp.w   d2,d0
        ble.s   .above\@
        move.w  d0,d2
.above\@
        endm

        routine mesh_link,a0
        save_all
        movea.l gather_plan_from(a0),a1
        movea.l gather_plan_list(a0),a4
        move.l  gather_plan_full(a0),d6
        moveq   #0,d7
        movea.l a0,a6
.face   move.l  a1,d0
        beq     .done
        cmp.l   a4,d6
        blo     .done
        cmp.l   mesh_face_placed(a1),d7
        bne     .other
.same   move.l  a4,d5
        movea.l mesh_face_face(a1),a0
        move.l  scene_face_corner(a0),d0
        lea     (a3,d0.l*8),a2
        lea     (a2,d0.l*4),a2          ; scene_corner_sizeof
        moveq   #-3,d4
        add.l   scene_face_corners(a0),d4
        vertex  0
        move.l  a0,d3
        move.w  d0,d1
        move.w  d0,d2
        vertex  1
        widen
        vertex  2
        widen
        tst.l   d4
        bne.s   .more
.check  sub.w   d1,d2
        cmp.w   #SNAPPED_LINES*SNAPPED_ONE,d2
        bhs.s   .refuse
        movea.l mesh_face_next(a1),a1
        bra     .face

.more   subq.l  #1,d4                   ; TRIANGLE_CORNERS_MAX is 4
        bne.s   .refuse
        move.l  d3,(a4)+
        move.l  a0,(a4)+
        vertex  3
        widen
        bra.s   .check

.other  move.l  mesh_face_placed(a1),d0
        movea.l d0,a2
        move.l  mesh_placed_material(a2),d1
        cmp.l   gather_plan_material(a6),d1
        bne.s   .done
        move.l  mesh_placed_flags(a2),d1
        cmp.l   gather_plan_flags(a6),d1
        bne.s   .done
        move.l  d0,d7
        movea.l mesh_placed_corners(a2),a3
        movea.l mesh_placed_places(a2),a5
        bra     .same

.refuse movea.l d5,a4
.done   move.l  a4,gather_plan_last(a6)
        move.l  a1,d0
        movea.l d0,a0                   ; where GCC expects a pointer
        return_all
