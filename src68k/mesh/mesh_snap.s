        include "routine.i"

; mesh_snap - places of a mesh's points on the screen, snapped to 1/16 pixel
;
; in:      a0  const struct snap_plan*  count is 1 at least
; reads:   the plan; w, screen_x, screen_y and outside of count points
; writes:  place and depth of count entries at to: x and y as in struct snapped_vertex, negative if the
;          point is outside a border, or x or y is not from 0 to the largest; w
; formats: screen 16.16; the largest x and y 28.4; place 12.4 twice
; error:   1/32 pixel
        routine mesh_snap,a0
        movem.l d2-d7,-(sp)
        movem.l snap_plan_right(a0),d6-d7
        move.l  snap_plan_count(a0),d3
        movea.l snap_plan_to(a0),a1
        movea.l snap_plan_points(a0),a0
        move.l  #SNAPPED_HALF,d4
        moveq   #16-SNAPPED_BITS,d5
.point  tst.l   mesh_point_outside(a0)
        bne.s   .out
        move.l  mesh_point_screen_x(a0),d0
        add.l   d4,d0
        asr.l   d5,d0
        cmp.l   d6,d0
        bhi.s   .out
        move.l  mesh_point_screen_y(a0),d1
        add.l   d4,d1
        asr.l   d5,d1
        cmp.l   d7,d1
        bhi.s   .out
        add.w   #SNAPPED_ONE,d0
        swap    d0
        move.w  d1,d0
        add.w   #SNAPPED_ONE-1,d0
.placed move.l  d0,(a1)
        move.l  mesh_point_w(a0),mesh_place_depth(a1)
        lea     mesh_place_sizeof(a1),a1
        lea     mesh_point_sizeof(a0),a0
        subq.l  #1,d3
        bne.s   .point
        movem.l (sp)+,d2-d7
        rts
.out    moveq   #-1,d0
        bra.s   .placed
