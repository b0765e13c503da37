        include "routine.i"
        include "layout.i"
        include "plane.i"

        xref    texturing_wrap

; Pushes the vector (x, y, s, t) from the vertex in d4-d7 to that of the sides a1, and
; makes \2 its address. Uses d0-d3/a2.
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

; \3 = the pixel in the middle of the box a0, from \1 to \2, and \5 = the way to it from
; the coordinate \4. Uses d0.
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

; Puts the gradient d1:d2 into the field \2 as a step, rounded to the nearest multiple
; of 1 << \1 units. Uses d0.
step    macro
        move.l  #$8000,d0
        lsl.l   \1,d0
        add.l   d0,d2
        bcc.s   .carried\@
        addq.l  #1,d1
.carried\@
        move.w  d1,d2
        swap    d2
        lsr.l   \1,d2
        lsl.l   \1,d2
        move.l  d2,texturing_\2(a6)
        endm

;==============================================================================
; texturing_plane - how s and t run over the plane of a polygon
;
; in:      a0  texturing*  what is filled in
;          a1  sides*      the polygon, its area not 0
;          d0  rectangle*  the pixels that it may cover
;          d1  int32       enum chain
; out:     -
; trashes: d0-d1/a0-a1
; reads:   *sides, top, bottom and apex vertex, the rectangle
; writes:  *texturing
; formats: with vectors from the top vertex to the bottom (1) and the apex (2), D =
;          x1 y2 - x2 y1 = +-area:
;            dsdx = (s1 y2 - s2 y1) / D     dsdy = (x1 s2 - x2 s1) / D
;          in 32.32 modulo 2^64; rounded to the nearest 16.16 (for u: to a multiple of
;          1 + spare units) they are the steps. i, j: the box's middle; u = s + (i - x)
;          dsdx + (j - y) dsdy there, each product rounded to the nearest unit
; error:   of a gradient g: |g| / 2^31 + 3 / 2^32 texels a pixel: D keeps 32 bits
;          (cut: up to 1 in 2^31), the numerator loses as many, the quotient is cut
; cost:    about 2,100 cycles, with a cold cache 2,600
;==============================================================================
        routine texturing_plane,a0,a1,d0,d1
        save_all
        move.l  d1,-(sp)                ; chain
        move.l  d0,-(sp)                ; box
        movea.l a0,a6
        movea.l d0,a0

        movea.l sides_top(a1),a2
        movem.l (a2),d4-d7
        move.l  d6,texturing_u(a6)
        move.l  d7,texturing_v(a6)
        vector  apex,a3
        vector  bottom,a2
        tst.b   sides_apex_right(a1)
        beq.s   .turned
        exg     a2,a3                   ; now D is positive
.turned
        middle  left,right,i,d4,a4      ; from the first vertex to (i, j)
        middle  top,bottom,j,d5,a5

        move.l  sides_area+number64_hi(a1),d0
        move.l  sides_area+number64_lo(a1),d7
        divisor

        gradient vertex_t,vertex_y
        rise    a4,v
        moveq   #0,d3
        step    d3,dvdx
        gradient vertex_x,vertex_t
        rise    a5,v
        moveq   #0,d3
        step    d3,dvdy

        movea.l a6,a0
        movea.l 32(sp),a1
        move.l  36(sp),d0
        jsr     texturing_wrap          ; bsr might not reach it

        gradient vertex_s,vertex_y
        rise    a4,u
        move.l  texturing_spare(a6),d3
        step    d3,dudx
        gradient vertex_x,vertex_s
        rise    a5,u
        move.l  texturing_spare(a6),d3
        step    d3,dudy
        move.l  texturing_u(a6),d0
        lsr.l   d3,d0
        lsl.l   d3,d0
        or.l    texturing_guard(a6),d0
        move.l  d0,texturing_u(a6)
        lea     40(sp),sp
        return_all
