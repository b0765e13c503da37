        include "transform.i"

; mesh_near_face - the borders that a face is outside of; transforms those of its points that have not been
;
; in:      a0  const struct near_face*  its points: those with its stamp are transformed
; out:     d0  int32  NEAR_HIDDEN: all points are outside of one border; else the borders, enum mesh_outside, that a
;                     point is outside of
; reads:   the plan, the face, its corners, their points
; writes:  stamp, x, y, w and outside of the other points; screen_x and screen_y if outside is 0
; formats: as in mesh_transform_wide
; error:   mesh_transform_wide's
; cost:    bench row mesh_near_face: four corners, all transformed before

; a2 the point in the camera's space, a4 the plan, a5 the corner. On the stack: corners left, the borders that all
; points are outside of, those that one is.
        routine mesh_near_face,a0
        save_all
        movea.l a0,a4
        movea.l near_face_face(a4),a1
        move.l  scene_face_corner(a1),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        movea.l near_face_corners(a4),a5
        lea     (a5,d0.l*4),a5          ; scene_corner_sizeof
        clr.l   -(sp)
        moveq   #-1,d0
        move.l  d0,-(sp)
        move.l  scene_face_corners(a1),-(sp)
.corner moveq   #0,d0
        move.w  (a5),d0                 ; scene_corner_point
        lea     scene_corner_sizeof(a5),a5
        move.l  d0,d1
        lsl.l   #5,d1                   ; mesh_point_sizeof
        movea.l near_face_points(a4),a2
        adda.l  d1,a2
        move.l  near_face_stamp(a4),d1
        cmp.l   mesh_point_stamp(a2),d1
        beq     .known
        move.l  d1,mesh_point_stamp(a2)
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        movea.l near_face_from(a4),a0
        lea     (a0,d0.l*4),a0          ; scene_point_sizeof
        lea     near_face_rows(a4),a1
        transform_point near_face,near_face_shifts(a4)
.point  and.l   d4,4(sp)
        or.l    d4,8(sp)
        subq.l  #1,(sp)
        bne     .corner
        addq.l  #4,sp
        movem.l (sp)+,d0-d1
        tst.l   d0
        bne.s   .back
        move.l  d1,d0
        return_all
.known  move.l  mesh_point_outside(a2),d4
        bra.s   .point
.back   moveq   #NEAR_HIDDEN,d0
        return_all
