        include "routine.i"

; mesh_transform - places on the screen and depths of a mesh's points, with 16-bit operands
;
; in:      a0  const struct transform_plan*  marks of one point at least
; out:     d0  int32  how many marked ones are off the screen; -1: one is behind the eye, and those from it
;                     on have no place
; reads:   the plan, its view, the marks, the points that are marked
; writes:  place and depth of their entries at to
; formats: points whole numbers, -MESH_UNIT16 to MESH_UNIT16; factors up to MESH_FACTOR16, so that
;          a sum of both fits 16 bits; sums modulo 2^32; place as in struct snapped_vertex
; error:   for views that the tools wrote the place is the nearest to a point within 1/32 pixel of
;          the exact one: points and factors are within half a unit, see
;          tools/tmap/compiler/views16.py

; Two products and not three a sum: a x + b y = (a + y) (b + x) - a b - x y; x y is the point's, - a b
; is in the move. \2 = the sum of the row that begins with the view's \1. d5 x, d6 y, d7 z, a5 x y.
; Uses d1.
row     macro
        move.w  scene_view16_\1x(a6),\2
        add.w   d6,\2
        move.w  scene_view16_\1y(a6),d1
        add.w   d5,d1
        muls.w  d1,\2
        move.w  d7,d1
        muls.w  scene_view16_\1z(a6),d1
        add.l   d1,\2
        add.l   scene_view16_\1_move(a6),\2
        sub.l   a5,\2
        endm

        routine mesh_transform,a0
        save_all
        movea.l transform_plan_view(a0),a6
        movea.l transform_plan_to(a0),a1
        movea.l transform_plan_right(a0),a2
        movea.l transform_plan_bottom(a0),a3
        movea.l transform_plan_marks(a0),a4
        movea.l transform_plan_from(a0),a0
        move.w  scene_view16_divisor_shift(a6),d4
        clr.l   -(sp)
        bra.s   .next

.skip   lea     mesh_point16_sizeof(a0),a0
        lea     mesh_place_sizeof(a1),a1
.next   tst.b   (a4)+
        beq.s   .skip
        bpl     .end                    ; MARKS_END
.point  movea.l (a0)+,a5
        move.w  (a0)+,d5
        move.w  (a0)+,d6
        move.l  (a0)+,d7
        row     w,d2
        asr.l   d4,d2
        ble.s   .behind                 ; or it would divide by 0
        row     x,d3
        divu.l  d2,d3
        cmp.l   a2,d3                   ; a negative sum has too large a quotient too
        bhi.s   .off
        row     y,d0
        divu.l  d2,d0
        cmp.l   a3,d0
        bhi.s   .off
        swap    d3
        move.w  d0,d3
        add.l   #SNAPPED_ONE<<16+SNAPPED_ONE-1,d3
.placed move.l  d3,(a1)+
        addq.l  #mesh_place_depth-4,a1
        move.l  d2,(a1)+
        tst.b   (a4)+
        bmi     .point
        beq     .skip
.end    move.l  (sp)+,d0
        return_all
.off    moveq   #-1,d3
        addq.l  #1,(sp)
        bra.s   .placed
.behind addq.l  #4,sp
        moveq   #-1,d0
        return_all
