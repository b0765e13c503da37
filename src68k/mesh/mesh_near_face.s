        include "transform.i"

; mesh_near_face - the next face of a node, from the last one on, that is seen from the front and may be visible;
;                  transforms those of its points that have not been
;
; in:      a0  struct near_face*  slot is behind the next one, slots the last one; its points: those with its stamp are
;                                 transformed
; out:     d0  int32  NEAR_NONE: there is none left; else the borders, enum mesh_outside, that a point is outside of
; reads:   the plan, slots, their faces, corners, points, the gaps of lines
; writes:  slot; above, and box unless a point is not before the near plane; stamp, x, y, w, outside, screen_x and screen_y of points that had another stamp
; formats: normals 2.30, eye and distance 16.16; points as in mesh_transform_wide, but of those that are not before the
;          near plane, screen_x and screen_y are set too: NEAR_FAR pixels to the side of the border that is theirs
; error:   mesh_transform_wide's. Left out are faces whose points are all outside of one border, and of those without
;          a point before the near plane faces whose box has no pixel in a gap: it has the pixels that edges, as far off
;          as before and behind tell, may cover; of what borders cut, it is two pixels wider, as new corners are rounded
; cost:    bench row mesh_near_seen: a face from the back

; Adds the product of the normal's \1 and the eye's to d2:d3, if it is not 0. Uses d0-d1.
eye_part macro
        move.l  scene_face_\1(a3),d0
        beq.s   .none\@
        muls.l  near_face_eye_\1(a4),d1:d0
        add.l   d0,d3
        addx.l  d1,d2
.none\@
        endm

; Goes on at \1 if the pixels d4 to d5 are in no gap of the line whose first gap is a3, else to .visible.
in_gap  macro
.find\@ cmp.w   gap_last(a3),d4
        bgt.s   .next\@
        cmp.w   (a3),d5                 ; gap_left
        bge     .visible
        bra.s   \1
.next\@ movea.l gap_next(a3),a3
        bra.s   .find\@
        endm

; a1 the stamp, a2 the points, a3 the point, a4 the plan, a5 the corner; a0 the borders that a point is outside of, a6
; those that all are; d4-d7 the least and the greatest x and y. On the stack: behind the last corner.
        routine mesh_near_face,a0
        save_all
        movea.l a0,a4
        subq.l  #4,sp
        movea.l near_face_slot(a4),a2
.slot   cmpa.l  near_face_slots(a4),a2
        beq     .none
        lea     -near_slot_sizeof(a2),a2
        move.l  (a2),d0                 ; near_slot_face
        beq.s   .slot
        movea.l d0,a3
        moveq   #0,d2
        moveq   #0,d3
        eye_part x
        eye_part y
        eye_part z
        add.l   d3,d3                   ; 46 fraction bits -> 48, the upper longword's 16
        addx.l  d2,d2
        add.l   d3,d3
        addx.l  d2,d2
        cmp.l   scene_face_distance(a3),d2
        ble.s   .slot
        sub.l   scene_face_distance(a3),d2
        move.l  d2,near_face_above(a4)
        move.l  a2,near_face_slot(a4)
        movea.l near_slot_corners(a2),a5
        move.l  scene_face_corners(a3),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        lea     (a5,d0.l*4),a0          ; scene_corner_sizeof
        move.l  a0,(sp)
        movea.l near_face_points(a4),a2
        movea.l near_face_stamp(a4),a1
        suba.l  a0,a0
        movea.w #-1,a6
        move.l  #$7fffffff,d4
        move.l  d4,d6
        moveq   #1,d5
        ror.l   #1,d5
        move.l  d5,d7
.corner moveq   #0,d0
        move.w  (a5),d0                 ; scene_corner_point
        lsl.l   #5,d0                   ; mesh_point_sizeof
        lea     (a2,d0.l),a3
        lea     scene_corner_sizeof(a5),a5
        cmpa.l  mesh_point_stamp(a3),a1
        bne     .make
.known  movem.l mesh_point_screen_x(a3),d0-d2   ; screen_y, outside
        tst.l   d2
        bne     .outside
        suba.l  a6,a6
.x      cmp.l   d4,d0
        bge.s   .least_x
        move.l  d0,d4
.least_x
        cmp.l   d5,d0
        ble.s   .most_x
        move.l  d0,d5
.most_x cmp.l   d6,d1
        bge.s   .least_y
        move.l  d1,d6
.least_y
        cmp.l   d7,d1
        ble.s   .most_y
        move.l  d1,d7
.most_y cmpa.l  (sp),a5
        bne.s   .corner

        movea.l near_face_slot(a4),a2
        move.l  a6,d0
        bne     .slot
        movem.l near_face_before(a4),d0-d1      ; and behind
        add.l   d0,d4
        swap    d4
        ext.l   d4
        add.l   d1,d5
        swap    d5
        ext.l   d5
        add.l   d0,d6
        swap    d6
        ext.l   d6
        add.l   d1,d7
        swap    d7
        ext.l   d7
        move.l  a0,d0
        beq.s   .whole
        lsr.l   #1,d0                   ; MESH_NEAR
        bcs     .visible
        subq.l  #2,d4
        addq.l  #2,d5
        subq.l  #2,d6
        addq.l  #2,d7

; The box in the frame: its lines from the middle one on.
.whole  movem.l d4-d7,near_face_box(a4) ; left, right, top, bottom
        movem.l near_face_right(a4),d0-d1       ; and bottom
        cmp.l   d0,d4
        bgt     .slot
        cmp.l   d0,d5
        ble.s   .right
        move.l  d0,d5
.right  moveq   #0,d2
        tst.l   d5
        bmi     .slot
        tst.l   d4
        bpl.s   .left
        move.l  d2,d4
.left   tst.l   d6
        bpl.s   .top
        move.l  d2,d6
.top    cmp.l   d1,d7
        ble.s   .bottom
        move.l  d1,d7
.bottom cmp.l   d6,d7
        blt     .slot
        cmp.l   d4,d5
        blt     .slot
        add.w   #EDGE_BIAS,d4
        add.w   #EDGE_BIAS,d5
        move.l  d6,d0
        add.l   d7,d0
        lsr.l   #1,d0
        movea.l near_face_gaps(a4),a1
        lea     (a1,d0.l*4),a1
        movea.l a1,a5
        sub.l   d0,d7
        sub.l   d6,d0
        bra.s   .down
.lower  dbra    d7,.down
        subq.w  #1,d0
        bmi     .slot
.up     movea.l -(a5),a3
        in_gap  .upper
.upper  dbra    d0,.up
        bra     .slot
.down   movea.l (a1)+,a3
        in_gap  .lower

.outside
        move.l  a0,d3
        or.l    d2,d3
        movea.l d3,a0
        move.l  a6,d3
        and.l   d2,d3
        movea.l d3,a6
        bra     .x

.none   moveq   #NEAR_NONE,d0
        addq.l  #4,sp
        return_all
.visible
        move.l  a0,d0
        addq.l  #4,sp
        return_all

; Transforms the point a3, number d0 / 32 of the mesh's.
.make   movem.l d4-d7/a0-a3/a6,-(sp)
        movea.l a3,a2
        move.l  a1,mesh_point_stamp(a3)
        lsr.l   #3,d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        movea.l near_face_from(a4),a0
        adda.l  d0,a0                   ; scene_point_sizeof
        lea     near_face_rows(a4),a1
        transform_point near_face,near_face_shifts(a4),.beyond
.made   movem.l (sp)+,d4-d7/a0-a3/a6
        bra     .known

; Its place on the screen, if it is not before the near plane.
.beyond move.l  d4,8(a2)                ; mesh_point_outside
        moveq   #MESH_NEAR,d0
        and.l   d4,d0
        bne.s   .made
        movea.l d4,a1
        movem.l near_face_shifts(a4),d5-d6
        move.l  d2,d3
        lsr.l   #1,d3
        move.l  #NEAR_FAR<<16,d0
        moveq   #MESH_LEFT+MESH_RIGHT,d1
        and.l   d4,d1
        beq.s   .inside_x
        subq.l  #MESH_LEFT,d1
        bne.s   .far_x
        neg.l   d0
.far_x  move.l  d0,(a2)+
        bra.s   .y
.inside_x
        moveq   #0,d4
        point_screen a3,near_face_middle_x
.y      move.l  a1,d4
        move.l  #NEAR_FAR<<16,d0
        moveq   #MESH_ABOVE+MESH_BELOW,d1
        and.l   d4,d1
        beq.s   .inside_y
        subq.l  #MESH_ABOVE,d1
        bne.s   .far_y
        neg.l   d0
.far_y  move.l  d0,(a2)
        bra     .made
.inside_y
        moveq   #0,d4
        point_screen a6,near_face_middle_y
        bra     .made
