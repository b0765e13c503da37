        include "routine.i"

; mesh_transform_wide - camera and screen coordinates of a mesh's points
;
; in:      a0  const struct wide_plan*  count is 1 at least
; reads:   the plan, its view, count points
; writes:  to: x, y, w and outside of count entries; screen_x and screen_y if outside
;          is 0
; formats: points, x, y, w and screen 16.16; the view's factors 2.30. Sums must be
;          below 16,384, which MESH_REACH and MESH_AWAY ensure
; error:   x, y, w half a unit; screen_x, screen_y half a unit of the quotient of these
; cost:    bench rows mesh_transform_wide and mesh_transform_wide_outside

; d2 = a coordinate; d5-d7 the point in 14.18, a1 a row of the stack. The sum has 48
; fraction bits, so its upper longword is the result. The loop fits the instruction cache.
row     macro
        movem.l (a1)+,d2-d3
        move.l  d5,d0
        muls.l  (a1)+,d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        move.l  d6,d0
        muls.l  (a1)+,d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        move.l  d7,d0
        muls.l  (a1)+,d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        endm

; Projects \1, x or y, to the screen; \2: the middle. d2 depth, d3 half of it, d4 0, d5
; 16 + guard, d6 16 - guard.
screen  macro
        move.l  \1,d0
        move.l  d0,d1
        asr.l   d6,d1
        lsl.l   d5,d0
        add.l   d3,d0
        addx.l  d4,d1
        divs.l  d2,d1:d0                ; towards zero: remainder of the dividend's sign
        tst.l   d1
        minus   <subq.l #1,d0>
        add.l   \2(a4),d0
        move.l  d0,(a2)+
        endm

; On the stack: three times x0, y0 or z0 in 32.32 and three factors; two shifts.
shifts  equ     60
room    equ     shifts+8

        routine mesh_transform_wide,a0
        save_all
        movea.l a0,a4
        lea     -room(sp),sp
        movea.l wide_plan_view(a4),a1      ; factors come first
        lea     scene_view_x0(a1),a3
        movea.l sp,a2
        moveq   #2,d2
.prepare
        move.l  (a3)+,(a2)+
        move.l  #$80000000,(a2)+        ; half a unit
        move.l  (a1)+,(a2)+
        move.l  (a1)+,(a2)+
        move.l  (a1)+,(a2)+
        dbra    d2,.prepare
        moveq   #16,d0
        moveq   #16,d1
        add.l   wide_plan_guard(a4),d0
        sub.l   wide_plan_guard(a4),d1
        movem.l d0-d1,(a2)              ; the shifts of screen
        movea.l wide_plan_from(a4),a0
        move.l  wide_plan_count(a4),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        lea     (a0,d0.l*4),a5
        movea.l wide_plan_to(a4),a2

.point  movem.l (a0)+,d5-d7
        lsl.l   #2,d5
        lsl.l   #2,d6
        lsl.l   #2,d7
        movea.l sp,a1
        row
        movea.l d2,a3                   ; x
        row
        movea.l d2,a6                   ; y
        row
        move.l  a3,(a2)+
        move.l  a6,(a2)+
        move.l  d2,(a2)+

        moveq   #0,d4
        cmp.l   wide_plan_near_plane(a4),d2
        bge.s   .far
        moveq   #MESH_NEAR,d4
.far    move.l  d2,d3
        neg.l   d3
        cmp.l   a3,d3
        ble.s   .left
        addq.w  #MESH_LEFT,d4
.left   cmp.l   a3,d2
        bge.s   .right
        addq.w  #MESH_RIGHT,d4
.right  cmp.l   a6,d3
        ble.s   .above
        addq.w  #MESH_ABOVE,d4
.above  cmp.l   a6,d2
        bge.s   .below
        add.w   #MESH_BELOW,d4
.below  tst.w   d4
        bne.s   .outside
        movem.l shifts(sp),d5-d6
        move.l  d2,d3
        lsr.l   #1,d3
        screen  a3,wide_plan_middle_x
        screen  a6,wide_plan_middle_y
        move.l  d4,(a2)
        bra.s   .next
.outside
        addq.l  #8,a2
        move.l  d4,(a2)
.next   lea     12(a2),a2
        cmpa.l  a5,a0
        blo     .point
        lea     room(sp),sp
        return_all
