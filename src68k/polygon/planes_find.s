        include "plane.i"

; Adds the gradient d1:d2 times the offset \1(a5), cut to 48.16, to the plane at \2(a0). Uses d0-d4.
rise    macro
        move.l  plane_corners_\1(a5),d0
        bpl.s   .positive\@
        neg.l   d2                      ; both signs changed: the same product
        negx.l  d1
        neg.l   d0
.positive\@
        muls.l  d0,d3:d1                ; hhhh hhhh ....
        mulu.l  d0,d4:d2                ; .... llll llll
        add.l   d4,d1
        moveq   #0,d0
        addx.l  d0,d3
        move.w  d1,d2
        swap    d2
        move.w  d3,d1
        swap    d1
        add.l   d2,\2+screen_plane_at+number64_lo(a0)
        move.l  \2+screen_plane_at(a0),d0
        addx.l  d1,d0
        move.l  d0,\2+screen_plane_at(a0)
        endm

; Finds the plane of the value \1, at \2(a0).
plane   macro
        move.l  plane_corners_first+plane_corner_\1(a5),d0
        swap    d0
        move.w  d0,d1
        ext.l   d1
        clr.w   d0
        move.l  d1,\2+screen_plane_at(a0)
        move.l  d0,\2+screen_plane_at+number64_lo(a0)
        gradient plane_corner_\1,plane_corner_y
        movem.l d1-d2,\2+screen_plane_dx(a0)
        rise    x,\2
        gradient plane_corner_x,plane_corner_\1
        movem.l d1-d2,\2+screen_plane_dy(a0)
        rise    y,\2
        endm

; d5-d7, a2, a3 for planes, from the corners in a1, which are a5 then.
divided macro
        movea.l a1,a5
        lea     plane_corners_a(a5),a2
        lea     plane_corners_b(a5),a3
        move.l  plane_corners_area+number64_hi(a5),d0
        move.l  plane_corners_area+number64_lo(a5),d7
        divisor
        endm

; depth_plane_find - the plane of q through three corners
;
; in:      a0  screen_plane*   the plane to fill in
;          a1  const plane_corners*  a corner, two vectors and the pixel of at
; formats: with vectors a and b and D = xa yb - xb ya > 0:
;            dx = (va yb - vb ya) / D     dy = (xa vb - xb va) / D
;          v = q; at = v of the first corner + x dx + y dy, each product rounded
;          down; all in 48.16 modulo 2^64: far from the corners at may have wrapped
; error:   of a gradient g: |g| / 2^31 + 3 / 2^16 units a pixel: D keeps 32 bits
;          (cut: up to 1 in 2^31), the numerator loses as many, the quotient is cut
; cost:    about 900 cycles
        routine depth_plane_find,a0,a1
        save_all
        pea     plane_kept(pc)
        xdef    depth_plane_inside,_depth_plane_inside
; As depth_plane_find; keeps a0-a1/a4/a6, and a1 is a5 then.
_depth_plane_inside
depth_plane_inside
        divided
        plane   q,0
        rts
plane_kept
        return_all

; texel_planes_find - the planes of s and t through three corners
;
; like:    depth_plane_find
; in:      a0  texel_planes*   the planes to fill in
; formats: as depth_plane_find, of v = s and v = t
; cost:    about 1,800 cycles
        routine texel_planes_find,a0,a1
        save_all
        pea     planes_kept(pc)
        xdef    texel_planes_inside,_texel_planes_inside
; As texel_planes_find; keeps a0-a1/a4/a6, and a1 is a5 then.
_texel_planes_inside
texel_planes_inside
        divided
        plane   s,texel_planes_s
        plane   t,texel_planes_t
        rts
planes_kept
        return_all
