        include "eye.i"

; mesh_faces_wide - faces that are seen from the front and not wholly outside one border
;
; in:      a0  const struct faces_plan*  count is 1 at least
; out:     d0  int32  how many
; reads:   the plan, its mesh_placed, that one's view, count faces, their corners' points
; writes:  that many entries at to: order, face and placed
; formats: normals 2.30, eye and distance 16.16; order: the greatest depth, inverted
; error:   a face counts as seen if floor(normal * eye) is above its distance
; cost:    bench row mesh_faces_wide for four corners, mesh_faces_wide_back for those not seen
        routine mesh_faces_wide,a0
        save_all
        movea.l faces_plan_placed(a0),a4
        movea.l mesh_placed_view(a4),a1
        movem.l scene_view_eye_x(a1),d5-d7
        movea.l mesh_placed_corners(a4),a5
        movea.l mesh_placed_points(a4),a6
        movea.l faces_plan_to(a0),a3
        movea.l faces_plan_from(a0),a1
        move.l  a3,-(sp)
        move.l  faces_plan_count(a0),-(sp)
.face   eye_along a1,scene_face
        cmp.l   scene_face_distance(a1),d2
        ble.s   .next
        move.l  scene_face_corner(a1),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        lea     (a5,d0.l*4),a2          ; 12 bytes a corner
        move.l  scene_face_corners(a1),d4
        moveq   #-1,d3                  ; the borders that all corners are outside of
        moveq   #0,d2                   ; the greatest depth so far
.corner moveq   #0,d0
        move.w  (a2),d0                 ; scene_corner_point
        lsl.l   #5,d0                   ; mesh_point_sizeof
        lea     (a6,d0.l),a0
        move.l  mesh_point_w(a0),d1
        cmp.l   d1,d2
        bge.s   .nearer
        move.l  d1,d2
.nearer and.l   mesh_point_outside(a0),d3
        lea     scene_corner_sizeof(a2),a2
        subq.l  #1,d4
        bne.s   .corner
        tst.l   d3
        bne.s   .next
        not.l   d2
        move.l  d2,(a3)+
        addq.l  #mesh_face_face-4,a3
        move.l  a1,(a3)+
        move.l  a4,(a3)+
        lea     mesh_face_sizeof-mesh_face_a(a3),a3
.next   lea     scene_face_sizeof(a1),a1
        subq.l  #1,(sp)
        bne.s   .face
        addq.l  #4,sp
        move.l  a3,d0
        sub.l   (sp)+,d0
        lsr.l   #5,d0                   ; mesh_face_sizeof
        return_all
