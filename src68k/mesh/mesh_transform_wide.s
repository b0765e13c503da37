        include "transform.i"

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

; The loop fits the instruction cache.
.point  movea.l sp,a1
        transform_point wide_plan,shifts(sp)
        lea     12(a2),a2
        cmpa.l  a5,a0
        blo     .point
        lea     room(sp),sp
        return_all
