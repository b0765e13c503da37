        include "plane_error.i"

        xref    ranges_inside,corners_inside,depth_plane_inside,mul_wide

Q_ONE           equ     1<<30           ; q of the nearest vertex

        ifne    depth_corners+plane_corners_first
        fail    the first corner is not where a depth begins
        endc

; The plan's \1 of q, 32.32, from the plane's on the stack, 48.16. Uses d0-d1.
to_32   macro
        movem.l screen_plane_\1(sp),d0-d1
        swap    d0
        swap    d1
        move.w  d1,d0
        clr.w   d1
        movem.l d0-d1,perspective_plan_q+screen_plane_\1(a4)
        endm

; perspective_depth - the plane of q and the ranges of u and v of a polygon, and what its other planes are found from
;
; in:      a0  depth*        to fill in
;          a1  const setup*  vertices, sides and box of the polygon, and its perspective_plan to fill in
; out:     d0  int32         1; 0 if q is too inexact, as q of a vertex is below 4 times its error
; reads:   the setup, its vertices
; writes:  the depth; the plan's q, left, q_low, q_high, and what ranges_find writes
; formats: the plane is depth_plane_find's, 32.32; q_low of three vertices is their least q less the plane's error, of
;          more the least that the plane has at a vertex
; error:   that of depth_plane_find over the pixels from the first corner: |g| / 2^31 + 3 / 2^16 units each, rounded
;          up, is what `off` has
; cost:    about 3,000 cycles for 3 vertices

; The planes of s and t are not needed by polygons that are drawn from the far ends of their lines.

        routine perspective_depth,a0,a1
        save_all
        movea.l a0,a5
        movea.l a1,a6
        pea     depth_kept(pc)
        xdef    depth_inside,_depth_inside
; As perspective_depth; the depth is a5, the setup a6 and the perspective_plan a4 then. Keeps a5-a6.
_depth_inside
depth_inside
        lea     -corner_source_sizeof(sp),sp
        movea.l sp,a0
        movea.l setup_perspective(a6),a1
        move.l  setup_vertices(a6),d0
        move.l  setup_count(a6),d1
        jsr     ranges_inside           ; bases a unit up: quotients are cut
        movea.l a1,a4
        movem.l setup_sides+sides_top(a6),d0-d2         ; bottom, middle
        tst.b   setup_sides+sides_middle_right(a6)
        beq.s   .left
        exg     d1,d2
.left   movem.l d0-d2,corner_source_first(sp)           ; a, b
        move.l  corner_source_scale(sp),depth_scale(a5)
        movea.l a5,a0
        movea.l sp,a1
        jsr     corners_inside
        lea     corner_source_sizeof-screen_plane_sizeof(sp),sp

        ; from the first corner to the box's first pixel, and how far pixels are from it
        movem.l setup_box(a6),d0-d3
        move.l  d0,perspective_plan_left(a4)
        sub.l   d0,d2
        sub.l   d1,d3
        addq.l  #1,d2
        addq.l  #1,d3
        swap    d0
        swap    d1
        clr.w   d0
        clr.w   d1
        sub.l   plane_corner_x(a5),d0
        sub.l   plane_corner_y(a5),d1
        movem.l d0-d1,plane_corners_x(a5)
        tst.l   d0
        minus   <neg.l d0>
        tst.l   d1
        minus   <neg.l d1>
        clr.w   d0
        clr.w   d1
        swap    d0
        swap    d1
        add.l   d2,d0
        add.l   d3,d1
        movem.l d0-d1,depth_right(a5)   ; and down
        movem.l setup_sides+sides_area(a6),d0-d1
        movem.l d0-d1,plane_corners_area(a5)
        movea.l sp,a0
        movea.l a5,a1
        jsr     depth_plane_inside

        ; d4, d5: the least and the greatest q
        clr.l   depth_has_texels(a5)
        moveq   #3,d0
        move.l  setup_count(a6),d6
        cmp.l   d0,d6
        seq     d0
        neg.b   d0
        extb.l  d0
        move.l  d0,depth_is_triangle(a5)
        beq     .polygon
        move.l  #Q_ONE,d5
        move.l  plane_corners_a+plane_corner_q(a5),d4
        cmp.l   plane_corners_b+plane_corner_q(a5),d4
        ble.s   .lower
        move.l  plane_corners_b+plane_corner_q(a5),d4
.lower  tst.l   d4
        bmi.s   .below
        moveq   #0,d4
.below  add.l   plane_corner_q(a5),d4

.least  move.l  d4,depth_least(a5)
        moveq   #1,d7
        move.l  depth_right(a5),d2
        error_part dx,sp
        move.l  d0,d3
        move.l  depth_down(a5),d2
        error_part dy,sp
        add.l   d0,d3
        addq.l  #2,d3
        move.l  d3,depth_off(a5)
        move.l  d7,depth_gentle(a5)
        cmp.l   #TOO_STEEP,d3
        bge.s   .unsure
        move.l  d3,d0
        lsl.l   #2,d0
        cmp.l   d0,d4
        blt.s   .unsure
        tst.l   depth_is_triangle(a5)
        beq.s   .range
        sub.l   d3,d4
.range  movem.l d4-d5,perspective_plan_q_low(a4)        ; and q_high
        to_32   at
        to_32   dx
        to_32   dy
        moveq   #1,d0
.done   lea     screen_plane_sizeof(sp),sp
        rts
.unsure moveq   #0,d0
        bra.s   .done

        ; by the plane, which need not go through all vertices
.polygon
        movem.l screen_plane_at(sp),d0/d7
        swap    d0
        swap    d7
        move.w  d7,d0
        move.l  d0,d7
        move.l  #$7fffffff,d4
        moveq   #0,d5
        movea.l setup_vertices(a6),a2
        movem.l setup_box(a6),d2-d3
        swap    d2
        swap    d3
        clr.w   d2
        clr.w   d3
.vertex move.l  vertex_x(a2),d0
        sub.l   d2,d0
        lea     screen_plane_dx(sp),a0
        jsr     mul_wide
        movea.l d0,a3
        adda.l  d7,a3
        move.l  vertex_y(a2),d0
        sub.l   d3,d0
        lea     screen_plane_dy(sp),a0
        jsr     mul_wide
        add.l   a3,d0
        cmp.l   d4,d0
        bge.s   .not_least
        move.l  d0,d4
.not_least
        cmp.l   d5,d0
        ble.s   .not_most
        move.l  d0,d5
.not_most
        lea     vertex_sizeof(a2),a2
        subq.l  #1,d6
        bne.s   .vertex
        bra     .least
depth_kept
        return_all
