        include "plane.i"

        xref    texturing_wrap

; Pushes the vector (x, y, s, t) from the vertex in d4-d7 to the vertex \1 of the sides a1;
; \2 = its address. Uses d0-d3/a2.
vector  macro
        movea.l sides_\1(a1),a2
        movem.l (a2),d0-d3
        sub.l   d4,d0
        sub.l   d5,d1
        sub.l   d6,d2
        sub.l   d7,d3
        movem.l d0-d3,-(sp)
        movea.l sp,\2
        endm

; \3 = the pixel in the middle of the box a0, from \1 to \2, and \5 = its distance from the
; coordinate \4. Uses d0.
middle  macro
        move.l  rectangle_\1(a0),d0
        add.l   rectangle_\2(a0),d0
        asr.l   #1,d0
        move.l  d0,texturing_\3(a6)
        swap    d0
        clr.w   d0
        sub.l   \4,d0
        movea.l d0,\5
        endm

; Adds the gradient d1:d2 times the offset \1 to the field \2, rounded to the
; nearest. Uses d0/d3-d4.
rise    macro
        move.l  \1,d0
        move.l  d0,d3
        mulu.l  d2,d4:d3
        tst.l   d0
        bpl.s   .unsigned\@
        sub.l   d2,d4                   ; the offset was taken as 2^32 too large
.unsigned\@
        muls.l  d1,d0
        add.l   d4,d0
        add.l   d3,d3                   ; half a unit
        moveq   #0,d3
        addx.l  d3,d0
        add.l   d0,texturing_\2(a6)
        endm

; Pushes ways_all, ways_x and ways_y of the box a0, for step and raise. Uses d0-d3.
ways    macro
        move.l  texturing_i(a6),d2
        sub.l   rectangle_left(a0),d2
        move.l  texturing_j(a6),d3
        sub.l   rectangle_top(a0),d3
        move.l  a4,d0
        minus   <neg.l d0>
        clr.w   d0
        swap    d0
        move.l  a5,d1
        minus   <neg.l d1>
        clr.w   d1
        swap    d1
        add.l   d1,d0
        add.l   d2,d0
        add.l   d3,d0
        addq.l  #2,d0
        add.l   d0,d0
        movem.l d0/d2-d3,-(sp)
        endm

; Puts the gradient d1:d2 into the field \1 as a step, rounded to the nearest multiple of
; 1 << d3 units. Adds to a0 the magnitude of the rounding error over \2 pixels, in 1/65536
; unit, and to a1 that of the gradient's whole texels. Uses d0-d2/d4.
step    macro
        move.l  d1,d0
        minus   <not.l d0>
        adda.l  d0,a1
        move.l  #$8000,d0
        lsl.l   d3,d0
        add.l   d0,d2
        bcc.s   .carried\@
        addq.l  #1,d1
.carried\@
        move.l  d0,d4
        add.l   d4,d4
        subq.l  #1,d4
        and.l   d2,d4
        sub.l   d4,d0
        minus   <neg.l d0>
        mulu.l  \2(sp),d0
        adda.l  d0,a0
        move.w  d1,d2
        swap    d2
        lsr.l   d3,d2
        lsl.l   d3,d2
        move.l  d2,texturing_\1(a6)
        endm

; Raises \1 (u or v) by the most that it may be below the plane anywhere in the box, and
; to a multiple of 1 << d3 units. Uses d0-d1.
raise   macro
        moveq   #5,d0
        add.l   a1,d0
        mulu.l  ways_all(sp),d1:d0
        move.w  d1,d0
        swap    d0
        move.l  a0,d1
        clr.w   d1
        swap    d1
        add.l   d1,d0
        addq.l  #3,d0
        add.l   texturing_\1(a6),d0
        moveq   #-1,d1
        lsl.l   d3,d1
        sub.l   d1,d0
        subq.l  #1,d0
        and.l   d1,d0
        move.l  d0,texturing_\1(a6)
        endm

; Finds \1, u or v, and its steps from the plane of \2, s or t; a0 and a1 are 0.
axis    macro
        gradient vertex_\2,vertex_y
        rise    a4,\1
        move.l  texturing_\1_cut(a6),d3
        step    d\1dx,ways_x
        gradient vertex_x,vertex_\2
        rise    a5,\1
        move.l  texturing_\1_cut(a6),d3
        step    d\1dy,ways_y
        raise   \1
        endm

; On the stack:
ways_all        equ     0               ; twice the pixels from the first vertex to the
                                        ; farthest pixel, x and y added
ways_x          equ     4               ; pixels from the middle to the box's sides
ways_y          equ     8
vectors         equ     12
box             equ     vectors+2*16
chain           equ     box+4

; texturing_plane - gradients of s and t on a polygon's plane, u and v in its box's middle
;
; in:      a0  texturing*  to fill in; its cuts are set: 0 to 8, 0 for a chain
;          a1  sides*      the polygon, its area not 0
;          d0  rectangle*  the pixels that it may cover
;          d1  int32       enum chain
; reads:   u_cut, v_cut; *sides, top, bottom and middle vertex, the rectangle
; writes:  *texturing except v_cut; u_cut if the chain needs a bit; with CHAIN_SHADES v and its
;          steps are 0
; formats: with vectors from the top vertex to the bottom (1) and the middle (2), D =
;          x1 y2 - x2 y1 = +-area:
;            dsdx = (s1 y2 - s2 y1) / D     dsdy = (x1 s2 - x2 s1) / D
;          in 32.32 modulo 2^64; rounded to the nearest multiple of 1 << cut units of
;          16.16 they are the steps. i, j: the box's middle; u = s + (i - x) dsdx +
;          (j - y) dsdy there, each product rounded to the nearest unit; then raised by
;          the most that it may be below the plane at any pixel of the box, so that a
;          texel's border shows the texel that begins there, and to a multiple of 1 << cut
;          units
; error:   of a gradient g: e(g) = |g| / 2^31 + 3 / 2^32 texels a pixel: D keeps 32 bits
;          (cut: up to 1 in 2^31), the numerator loses as many, the quotient is cut. In
;          the box u is never below the plane if gradients are below 2^30 texels a
;          pixel: raised by |step - dsdx| over half the box, by e over the way from the
;          first vertex to the farthest pixel, and by 1 for the two products
; cost:    about 2,700 cycles, with a cold cache 3,200
        routine texturing_plane,a0,a1,d0,d1
        save_all
        move.l  d1,-(sp)
        move.l  d0,-(sp)
        movea.l a0,a6
        movea.l d0,a0

        movea.l sides_top(a1),a2
        movem.l (a2),d4-d7
        move.l  d6,texturing_u(a6)
        move.l  d7,texturing_v(a6)
        vector  middle,a3
        vector  bottom,a2
        tst.b   sides_middle_right(a1)
        beq.s   .turned
        exg     a2,a3                   ; now D is positive
.turned
        middle  left,right,i,d4,a4      ; from the first vertex to (i, j)
        middle  top,bottom,j,d5,a5
        ways
        move.l  sides_area+number64_hi(a1),d0
        move.l  sides_area+number64_lo(a1),d7
        divisor
        suba.l  a0,a0
        suba.l  a1,a1

        move.l  chain(sp),d0
        subq.l  #CHAIN_SHADES,d0
        beq     .shades
        axis    v,t

        movea.l a6,a0
        movea.l box(sp),a1
        move.l  chain(sp),d0
        jsr     texturing_wrap
        suba.l  a0,a0
        suba.l  a1,a1

.u      axis    u,s
        move.l  texturing_wrap_bit(a6),d0
        or.l    d0,texturing_u(a6)
        lea     chain+4(sp),sp
        return_all
.shades clr.l   texturing_v(a6)
        clr.l   texturing_dvdx(a6)
        clr.l   texturing_dvdy(a6)
        clr.l   texturing_wraps(a6)
        clr.l   texturing_wrap_bit(a6)
        bra     .u
