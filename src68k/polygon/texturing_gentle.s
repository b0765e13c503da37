        include "gentle.i"
        include "starts.i"

        xref    _texturing_plane,_texturing_starts,texturing_wrap

; Pushes the vector (x, y, s, t) from the vertex in d4-d7 to the vertex \1 of the setup's sides;
; \2 = its address. Uses d0-d3/a2.
vector  macro
        movea.l sides+sides_\1(a6),a2
        movem.l (a2),d0-d3
        sub.l   d4,d0
        sub.l   d5,d1
        sub.l   d6,d2
        sub.l   d7,d3
        movem.l d0-d3,-(sp)
        movea.l sp,\2
        endm

; \1 = the distance from the coordinate \2 to the pixel \1, 10.22. Goes to .far if that has no room.
distance macro
        swap    \1
        clr.w   \1
        sub.l   \2,\1
        asl.l   #6,\1
        bvs     .far
        endm

; How far v of a pixel may be outside the vertices' range, in 1/1024 texel. Edges are within 1/64 pixel
; along a line, at less than 16 texels a pixel: 256. Four cuts by clipping move vertices by 1/2^17 pixel
; each, in x or in y: 2. Steps are off by 1/2^17 over WAYS_MOST pixels: 2; v is raised by as much: 2.
; Gradients, 3.1 units of 2^-16, as much again, and RAISED: 1. Corners beyond three may be off the
; plane by 1/64: 16. The sum is 279; MARGIN is 512.
MARGIN          equ     1<<15

; texturing_gentle - the plane of a polygon, relative to the first pixel on its left side
;
; in:      a6  setup*  the polygon, with sides of an area that is not 0, box and edges; the cuts of
;                      its texturing are set: 0 to 8, 0 for a chain
;          d1  int32   enum chain
; out:     d0  int32   POLYGON_DRAWN
; trashes: d1-d7/a0-a5
; reads:   vertices, count, sides, box, left edges, u_cut, v_cut
; writes:  texturing except v_cut; u_cut if the chain needs a bit; with CHAIN_SHADES v and its steps
;          are 0; u, v, du, dv of the left edges as texturing_starts
; formats: as texturing_plane, but with gradients in 6.26, and (i, j) is the first pixel right of the
;          left side. It does all the work itself if twice the area is 1/2 to 2^20 square pixels,
;          gradients are below 8 texels a pixel (2^(k+4) / twice the area, if that is 2^k or more), the top
;          vertex is within 512 pixels of (i, j), in x and in y, and the box's farthest sides are
;          within WAYS_MOST, x and y added. texturing_plane and texturing_starts do it otherwise. u is
;          raised by the most that it may be below the plane at any pixel of the box. v does not
;          wrap if MARGIN around the range of its vertices is between two multiples of 256
; error:   of a gradient: e = 2.5 / 2^26 texels a pixel. With D cut to 31 bits, it is a unit too large at
;          most (1 in 2^30 of 16 texels); the numerator, cut to 32 bits, and the reciprocal of D, cut
;          to 31, each take half a unit at most, cutting the product one. Raised by half of 1 << cut
;          units a pixel over the box and by RAISED
; cost:    about 1,450 cycles with a cold cache, 800 for CHAIN_SHADES
        routine texturing_gentle
        move.l  d1,-(sp)
        movea.l sides+sides_top(a6),a2
        movem.l (a2),d4-d7
        move.l  d6,texturing+texturing_u(a6)
        move.l  d7,texturing+texturing_v(a6)
        vector  middle,a3
        vector  bottom,a2
        tst.b   sides+sides_middle_right(a6)
        beq.s   .turned
        exg     a2,a3                   ; now D is positive
.turned jmp     texturing_gentle_from

; texturing_gentle_from - the same from two vectors
;
; in:      a6  setup*  as texturing_gentle takes it; u and v of its texturing are s and t of the top
;                      vertex
;          d4  fix16   x of the top vertex
;          d5  fix16   y of the top vertex
;          a2  fix16*  x, y, s, t from the top vertex to another one
;          a3  fix16*  and to the third, clockwise
; out:     d0  int32   POLYGON_DRAWN
; trashes: d1-d7/a0-a5
; reads:   as texturing_gentle; on the stack below the return address: the chain, 32 bytes of vectors
; writes:  as texturing_gentle; takes these from the stack
; formats: as texturing_gentle
; error:   as texturing_gentle
; cost:    about 1,250 cycles with a cold cache, 600 for CHAIN_SHADES
        routine texturing_gentle_from
        movea.l edges+edge_plan_left(a6),a0
        move.l  edge_x(a0),d2
        sub.l   #EDGE_BIAS,d2
        move.l  box+rectangle_top(a6),d3
        movem.l d2-d3,texturing+texturing_i(a6)         ; and j
        move.l  box+rectangle_right(a6),d0
        sub.l   d2,d0
        move.l  d2,d1
        sub.l   box+rectangle_left(a6),d1
        cmp.l   d1,d0
        bge.s   .farther
        move.l  d1,d0
.farther
        add.l   box+rectangle_bottom(a6),d0
        sub.l   d3,d0
        cmp.l   #WAYS_MOST,d0
        bhi     .far
        distance d2,d4
        distance d3,d5
        movea.l d2,a4
        movea.l d3,a5
        move.l  d0,-(sp)
        subq.l  #4,sp

        move.l  sides+sides_area+number64_hi(a6),d0
        move.l  sides+sides_area+number64_lo(a6),d7
        add.l   d7,d7
        addx.l  d0,d0
        bfffo   d0{0:32},d5
        beq     .handed
        moveq   #11,d1
        cmp.l   d1,d5
        blo     .handed
        subq.l  #1,d5
        lsl.l   d5,d0
        moveq   #32,d6
        sub.l   d5,d6
        lsr.l   d6,d7
        or.l    d0,d7                   ; D, 31 bits
        subq.l  #2,d5
        addq.l  #2,d6
        move.l  #(1<<29)-1,d0
        moveq   #-1,d1
        divu.l  d7,d0:d1
        move.l  d1,d7

        move.l  chain(sp),d0
        subq.l  #CHAIN_SHADES,d0
        beq     .shades
        axis    v,t
        move.l  chain(sp),d0
        beq.s   .whole
        subq.l  #CHAIN_ANYWHERE,d0
        beq     .wraps
        movea.l setup_vertices(a6),a0
        move.l  setup_count(a6),d3
        subq.w  #2,d3
        move.l  vertex_t(a0),d0
        move.l  d0,d1
.vertex lea     vertex_sizeof(a0),a0
        move.l  vertex_t(a0),d2
        cmp.l   d2,d0
        ble.s   .not_least
        move.l  d2,d0
.not_least
        cmp.l   d2,d1
        bge.s   .not_greatest
        move.l  d2,d1
.not_greatest
        dbra    d3,.vertex
        sub.l   #MARGIN,d0
        add.l   #MARGIN,d1
        eor.l   d0,d1
        cmp.l   #1<<24,d1
        bhs     .wraps
.whole  clr.l   texturing+texturing_wraps(a6)
        clr.l   texturing+texturing_wrap_bit(a6)
.u      axis    u,s
        move.l  texturing+texturing_wrap_bit(a6),d0
        beq.s   .free
        or.l    d0,texturing+texturing_u(a6)
.free   lea     size(sp),sp

        movea.l edges+edge_plan_left(a6),a1
        move.l  edge_whole(a1),d4
        lea     texturing(a6),a0
        start_step u
        move.l  texturing_u(a0),edge_u(a1)
        start_step v
        move.l  texturing_v(a0),edge_v(a1)
        move.w  edges+edge_plan_lefts+2(a6),d7
.next   subq.w  #1,d7
        beq     .done
        lea     edge_sizeof(a1),a1
        start_edge
        bra     .next
.done   moveq   #POLYGON_DRAWN,d0
        rts

.shades clr.l   texturing+texturing_v(a6)
        clr.l   texturing+texturing_dvdx(a6)
        clr.l   texturing+texturing_dvdy(a6)
        bra     .whole
.wraps  lea     texturing(a6),a0
        lea     box(a6),a1
        moveq   #CHAIN_ANYWHERE,d0      ; of CHAIN_PLANE, v is not at the middle
        moveq   #CHAIN_WHOLE,d1
        cmp.l   chain(sp),d1
        bne.s   .once
        moveq   #1,d0
        move.l  d0,texturing_wraps(a0)
        clr.l   texturing_wrap_bit(a0)
        bra     .u
.once   jsr     texturing_wrap
        bra     .u

.handed addq.l  #8,sp
.far    lea     2*16(sp),sp
        move.l  (sp)+,d1
        xdef    texturing_far,_texturing_far
; As texturing_gentle, by texturing_plane and texturing_starts; keeps d2-d7/a2-a6.
_texturing_far
texturing_far
        tst.l   d1
        beq.s   texturing_uncut
        clr.l   texturing+texturing_u_cut(a6)
texturing_uncut
        move.l  d1,-(sp)
        pea     box(a6)
        pea     sides(a6)
        pea     texturing(a6)
        jsr     _texturing_plane
        move.l  edges+edge_plan_lefts(a6),-(sp)
        move.l  edges+edge_plan_left(a6),-(sp)
        pea     texturing(a6)
        jsr     _texturing_starts
        lea     7*4(sp),sp
        moveq   #POLYGON_DRAWN,d0
        rts
