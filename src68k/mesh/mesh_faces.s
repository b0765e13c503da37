        include "routine.i"

; mesh_faces - faces that are seen from the front, by 16-bit operands, and the points that they have
;
; in:      a0  const struct faces_plan*  count is 1 at least
; out:     d0  int32  how many
; reads:   the plan, its mesh_placed, that one's view16, count faces, corners of those seen
; writes:  that many entries at to: face and placed; MARKED to their points' marks
; formats: normals' upper words 2.14, the view16's eye
; error:   of the eye's height above a face: less than 2^-14 of the sum of its three coordinates, for
;          the normal, and 3 units of the eye's format
; cost:    bench row mesh_faces for four corners, mesh_faces_back for those not seen

; d5-d7 the eye, d4 seen_shift, d2 MARKED, a2 behind the last face, a3 to, a4 the mesh_placed, a5 its
; corners, a6 the marks
; Marks the point of the corner \1 behind a0. Uses d0.
corner  macro
        move.w  \1*scene_corner_sizeof(a0),d0   ; scene_corner_point, below MESH_COUNT_MAX
        move.b  d2,(a6,d0.w)
        endm

        routine mesh_faces,a0
        save_all
        movea.l faces_plan_placed(a0),a4
        movea.l mesh_placed_view16(a4),a1
        move.w  scene_view16_eye_x(a1),d5
        move.w  scene_view16_eye_y(a1),d6
        move.w  scene_view16_eye_z(a1),d7
        move.w  scene_view16_seen_shift(a1),d4
        movea.l mesh_placed_corners(a4),a5
        movea.l faces_plan_marks(a0),a6
        movea.l faces_plan_to(a0),a3
        movea.l faces_plan_from(a0),a1
        moveq   #scene_face_sizeof,d0
        mulu.l  faces_plan_count(a0),d0
        lea     (a1,d0.l),a2
        moveq   #-1,d2                  ; MARKED
        move.l  a3,-(sp)
.face   move.w  d5,d0
        muls.w  (a1),d0                 ; scene_face_x
        move.w  d6,d1
        muls.w  scene_face_y(a1),d1
        add.l   d1,d0
        move.w  d7,d1
        muls.w  scene_face_z(a1),d1
        add.l   d1,d0
        asr.l   d4,d0
        cmp.l   scene_face_distance(a1),d0
        ble.s   .next
        addq.l  #mesh_face_face,a3
        move.l  a1,(a3)+
        move.l  a4,(a3)+
        lea     mesh_face_sizeof-mesh_face_a(a3),a3
        move.l  scene_face_corner(a1),d0
        lea     (a5,d0.l*8),a0
        lea     (a0,d0.l*4),a0          ; scene_corner_sizeof
        moveq   #-3,d3
        add.l   scene_face_corners(a1),d3
        corner  0
        corner  1
        corner  2
        tst.l   d3
        bne.s   .more
.next   lea     scene_face_sizeof(a1),a1
        cmpa.l  a2,a1
        bne.s   .face
        move.l  a3,d0
        sub.l   (sp)+,d0
        lsr.l   #5,d0                   ; mesh_face_sizeof
        return_all
.more   corner  3
        lea     scene_corner_sizeof(a0),a0
        subq.l  #1,d3
        bne.s   .more
        bra.s   .next
