        include "plane_error.i"

        xref    texel_planes_inside

        ifne    depth_corners
        fail    the corners are not where a depth begins
        endc

; perspective_texels - the planes of s and t of a polygon, unless they have been found
;
; in:      a0  perspective_plan*  s, t and gentle to fill in
;          a1  depth*             as perspective_depth fills it in
; out:     d0  int32              1; 0 if the planes are too inexact, as q of a vertex is below 4 times their error
; reads:   the depth
; writes:  the plan's s, t and gentle, and the depth's has_texels, unless they are too inexact
; formats: texel_planes_find's, times 2^(scale - 16). The planes are raised so that s / q is never below u: q's error
;          changes s by less than itself, as u less its base is below 2^scale; rounding at each corner adds less than
;          half a unit and one, times the pixel's shares of the corners, 1 in a triangle and 3 in others
; error:   texel_planes_find's, as perspective_depth's
; cost:    about 2,300 cycles

        routine perspective_texels,a0,a1
        moveq   #1,d0
        tst.l   depth_has_texels(a1)
        bne     .found
        save_all
        movea.l a0,a4
        lea     -texel_planes_sizeof(sp),sp
        movea.l sp,a0
        jsr     texel_planes_inside
        moveq   #4,d5                   ; for two of the shares, and 2
        tst.l   depth_is_triangle(a5)
        bne.s   .raise
        moveq   #8,d5
.raise  add.l   depth_off(a5),d5
        move.l  depth_gentle(a5),d6
        movea.l sp,a3
        bsr.s   .plane
        bne.s   .done
        lea     texel_planes_t-texel_planes_s(a3),a3
        bsr.s   .plane
        bne.s   .done

        move.l  d6,perspective_plan_gentle(a4)
        moveq   #1,d0
        move.l  d0,depth_has_texels(a5)
        lea     perspective_plan_s(a4),a4
        movea.l sp,a3
        moveq   #-16,d5
        add.l   depth_scale(a5),d5
        moveq   #32,d6
        sub.l   d5,d6
        moveq   #2*screen_plane_sizeof/number64_sizeof-1,d7
.scale  movem.l (a3)+,d0-d1
        lsl.l   d5,d0
        move.l  d1,d2
        lsr.l   d6,d2                   ; by 32: 0
        or.l    d2,d0
        lsl.l   d5,d1
        move.l  d0,(a4)+
        move.l  d1,(a4)+
        dbra    d7,.scale
        moveq   #1,d0
        bra.s   .sure
.done   moveq   #0,d0
.sure   lea     texel_planes_sizeof(sp),sp
        movem.l (sp)+,d2-d7/a2-a6
.found  rts

; Raises the plane a3 by d5 and what it may be off. Out: Z if that is sure; d6 = 0 if its step to the next pixel is not
; gentle. Uses d0-d4/d7.
.plane  move.l  depth_down(a5),d2
        error_part dy,a3
        move.l  d0,d3
        moveq   #1,d7
        move.l  depth_right(a5),d2
        error_part dx,a3
        and.l   d7,d6
        add.l   d0,d3
        addq.l  #2,d3
        cmp.l   #TOO_STEEP,d3
        bge.s   .unsure
        move.l  d3,d0
        lsl.l   #2,d0
        cmp.l   depth_least(a5),d0
        bgt.s   .unsure
        add.l   d5,d3
        moveq   #0,d4
        swap    d3
        move.w  d3,d4
        clr.w   d3                      ; d4:d3 units, 48.16
        movem.l screen_plane_at(a3),d0-d1
        add.l   d3,d1
        addx.l  d4,d0
        movem.l d0-d1,screen_plane_at(a3)
        moveq   #0,d0
        rts
.unsure moveq   #1,d0
        rts
