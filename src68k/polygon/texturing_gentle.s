        include "routine.i"

        xref    texturing_plane,texturing_wrap

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
; coordinate \4, 11.21. Goes to .far if that has no room. \6 = whole pixels of the distance,
; rounded down. Uses d0.
middle  macro
        move.l  rectangle_\1(a0),d0
        add.l   rectangle_\2(a0),d0
        asr.l   #1,d0
        move.l  d0,texturing_\3(a6)
        swap    d0
        clr.w   d0
        sub.l   \4,d0
        asl.l   #5,d0
        bvs     .far
        movea.l d0,\5
        minus   <neg.l d0>
        clr.w   d0
        swap    d0
        lsr.w   #5,d0
        move.l  d0,\6
        endm

; d1 = (p1 q2 - p2 q1) / D in 5.27, cut towards zero; p, q: the fields \1, \2. Goes to .steep if it
; may be 8 or more. d7 = D, cut to 31 bits; d5 = the left shift of the numerator that belongs to
; it, d6 = 32 - d5. a2, a3: the two vectors from the first vertex. Uses d0/d2-d3.
gradient macro
        move.l  \1(a2),d1
        muls.l  \2(a3),d0:d1
        move.l  \1(a3),d3
        muls.l  \2(a2),d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        move.l  d0,d2
        minus   <not.l d2>
        cmp.l   limit(sp),d2
        bhs     .steep
        lsl.l   d5,d0
        move.l  d1,d3
        lsl.l   d5,d1
        lsr.l   d6,d3
        or.l    d3,d0
        divs.l  d7,d0:d1
        endm

; Adds the gradient d1 times the distance \1 to d4, rounded to the nearest. Uses d0/d2.
rise    macro
        move.l  \1,d0
        muls.l  d1,d2:d0                ; 16.48
        add.l   d0,d0                   ; half a unit
        addx.l  d2,d4
        endm

; Puts the gradient d1 into the field \1 as a step, rounded to the nearest multiple of 1 << cut
; units, a1 being half of that. Adds to a0 the magnitude of the rounding error over \2 pixels, in
; 2^-27. Uses d0-d2.
step    macro
        move.l  a1,d0
        add.l   d0,d1
        move.l  d0,d2
        add.l   d2,d2
        subq.l  #1,d2
        and.l   d1,d2
        sub.l   d2,d0
        minus   <neg.l d0>
        mulu.w  \2+2(sp),d0
        adda.l  d0,a0
        asr.l   #8,d1
        asr.l   #3,d1
        and.l   mask(sp),d1
        move.l  d1,texturing_\1(a6)
        endm

; Finds \1, u or v, and its steps from the plane of \2, s or t.
axis    macro
        move.l  texturing_\1_cut(a6),d3
        moveq   #-1,d0
        lsl.l   d3,d0
        move.l  d0,mask(sp)
        move.l  #1<<10,d0
        lsl.l   d3,d0
        movea.l d0,a1
        movea.l ways_all(sp),a0         ; the gradients' errors, 2 in 2^27 a pixel
        move.l  texturing_\1(a6),d4
        gradient vertex_\2,vertex_y
        rise    a4
        step    d\1dx,ways_x
        gradient vertex_x,vertex_\2
        rise    a5
        step    d\1dy,ways_y
        move.l  a0,d0
        lsr.l   #8,d0
        lsr.l   #3,d0
        addq.l  #2,d0
        add.l   d4,d0
        move.l  mask(sp),d1
        sub.l   d1,d0
        subq.l  #1,d0
        and.l   d1,d0                   ; up to a multiple of 1 << cut
        move.l  d0,texturing_\1(a6)
        endm

; \4 = travel of v by step \1 over half the box a0, from the middle \2 to \3, 8.8, rounded up; goes
; to .wraps if it is 256 texels or more. Uses d1.
travel  macro
        move.l  texturing_\1(a6),\4
        minus   <neg.l \4>
        lsr.l   #8,\4
        addq.w  #1,\4
        move.l  rectangle_\3(a0),d1
        sub.l   texturing_\2(a6),d1
        mulu.w  d1,\4
        swap    \4
        tst.w   \4
        bne     .wraps
        swap    \4
        endm

; On the stack:
ways_all        equ     0               ; twice the pixels from the first vertex to the
                                        ; farthest pixel, x and y added
ways_x          equ     4               ; pixels from the middle to the box's sides
ways_y          equ     8
mask            equ     12              ; -(1 << cut)
limit           equ     16              ; of a numerator's upper half
vectors         equ     20
chain           equ     vectors+2*16
box             equ     chain+4
outline         equ     box+4
size            equ     outline+4

; texturing_gentle - the plane of a polygon whose texels are not small
;
; in:      a6  texturing*  to fill in; its cuts are set: 0 to 8, 0 for a chain
;          a1  sides*      the polygon, its area not 0
;          a0  rectangle*  the pixels that it may cover
;          d1  int32       enum chain
; trashes: d0-d7/a0-a5
; reads:   u_cut, v_cut; *sides, top, bottom and middle vertex, the rectangle
; writes:  *texturing except v_cut; u_cut if the chain needs a bit; with CHAIN_SHADES v and its
;          steps are 0
; formats: as texturing_plane, but with gradients in 5.27. It does all of texturing_plane's work
;          itself if they are below 8 texels a pixel, twice the area is 1/2 to 2^20 square pixels,
;          and the top vertex is within 1,024 pixels of the middle of the box, in x and in y.
;          texturing_plane finds other planes. u is raised by the most that it may be below the
;          plane at any pixel of the box, as there
; error:   of a gradient: e = 2 / 2^27 texels a pixel: D keeps 31 bits (cut: 1 in 2^30 of 8
;          texels), the quotient is cut. Raised by |step - dsdx| over half the box, by e over the
;          way from the first vertex to the farthest pixel, and by 1 for the two products
; cost:    about 1,700 cycles with a cold cache, 1,000 for CHAIN_SHADES
        routine texturing_gentle
        movem.l d1/a0-a1,-(sp)
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
        middle  left,right,i,d4,a4,d2   ; from the first vertex to (i, j)
        middle  top,bottom,j,d5,a5,d3
        move.l  sides_area+number64_hi(a1),d0
        move.l  sides_area+number64_lo(a1),d7
        bfffo   d0{0:32},d5
        move.l  d7,d1
        rol.l   #3,d1
        and.w   #7,d1
        move.l  d0,d4
        lsl.l   #3,d4
        or.w    d1,d4                   ; D >> 29
        moveq   #12,d1
        cmp.l   d1,d5
        blo     .far
        moveq   #4,d1
        cmp.l   d1,d4
        blo     .far
        move.l  d4,-(sp)
        subq.l  #4,sp
        moveq   #33,d6
        sub.l   d5,d6
        lsr.l   d6,d7
        subq.l  #1,d5
        lsl.l   d5,d0
        or.l    d0,d7
        subq.l  #5,d5
        moveq   #32,d6
        sub.l   d5,d6

        move.l  d2,d0
        add.l   d3,d0
        move.l  texturing_i(a6),d2
        sub.l   rectangle_left(a0),d2
        move.l  texturing_j(a6),d3
        sub.l   rectangle_top(a0),d3
        add.l   d2,d0
        add.l   d3,d0
        addq.l  #2,d0
        add.l   d0,d0
        movem.l d0/d2-d3,-(sp)

        move.l  chain(sp),d0
        subq.l  #CHAIN_SHADES,d0
        beq     .shades
        axis    v,t

        ; texturing_wrap's first test, with steps below 8 texels
        movea.l box(sp),a0
        travel  dvdx,i,right,d2
        travel  dvdy,j,bottom,d0
        add.w   d2,d0                   ; below 2^16: v's range in the box, 8.8
        bcs     .wraps
        addq.w  #1,d0
        bcs     .wraps
        move.l  texturing_v(a6),d1
        lsr.l   #8,d1
        cmp.w   d0,d1
        blo     .wraps
        add.w   d0,d1
        bcs     .wraps
        moveq   #CHAIN_ANYWHERE,d0
        cmp.l   chain(sp),d0
        beq     .wraps
.whole  clr.l   texturing_wraps(a6)
        clr.l   texturing_wrap_bit(a6)
.u      axis    u,s
        move.l  texturing_wrap_bit(a6),d0
        or.l    d0,texturing_u(a6)
        lea     size(sp),sp
        rts
.shades clr.l   texturing_v(a6)
        clr.l   texturing_dvdx(a6)
        clr.l   texturing_dvdy(a6)
        bra     .whole
.wraps  movea.l a6,a0
        movea.l box(sp),a1
        move.l  chain(sp),d0
        jsr     texturing_wrap
        bra     .u

.steep  lea     chain-ways_all(sp),sp
        bra.s   .other
.far    lea     chain-vectors(sp),sp
.other  movem.l (sp)+,d1/a0-a1
        tst.l   d1
        beq.s   .unchained
        clr.l   texturing_u_cut(a6)
.unchained
        move.l  a0,d0
        movea.l a6,a0
        jmp     texturing_plane
