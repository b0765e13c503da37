        include "starts.i"

        xref    texturing_plane,texturing_starts,texturing_wrap

texturing       equ     setup_texturing
edges           equ     setup_edges
sides           equ     setup_sides
box             equ     setup_box

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

; \3 = the distance from the coordinate \2 to the pixel \1, 11.21. Goes to .far if that has no room.
; \2 = its whole pixels, rounded down. Uses d0.
distance macro
        move.l  \1,d0
        swap    d0
        clr.w   d0
        sub.l   \2,d0
        asl.l   #5,d0
        bvs     .far
        movea.l d0,\3
        minus   <neg.l d0>
        clr.w   d0
        swap    d0
        lsr.w   #5,d0
        move.l  d0,\2
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
; units, a1 being half of that. \2: "whole" if cut is 0. Uses d1.
step    macro
        add.l   a1,d1
        asr.l   #8,d1
        asr.l   #3,d1
        ifc     '\2',''
        and.l   mask(sp),d1
        endc
        move.l  d1,texturing+texturing_\1(a6)
        endm

; Finds \1, u or v, and its steps from the plane of \2, s or t. a1, d4: half of 1 << cut, and by how
; much \1 is raised. \3: as step.
steps   macro
        add.l   texturing+texturing_\1(a6),d4
        gradient vertex_\2,vertex_y
        rise    a4
        step    d\1dx,\3
        gradient vertex_x,vertex_\2
        rise    a5
        step    d\1dy,\3
        endm

; The same for any cut.
axis    macro
        move.l  ways(sp),d4
        movea.w #1<<10,a1
        move.l  texturing+texturing_\1_cut(a6),d3
        bne     .cut\1
        add.l   way(sp),d4
        lsr.l   #8,d4
        lsr.l   #3,d4
        addq.l  #2,d4
        steps   \1,\2,whole
        bra     .found\1
.cut\1 moveq   #-1,d0
        lsl.l   d3,d0
        move.l  d0,mask(sp)
        move.l  a1,d0
        lsl.l   d3,d0
        movea.l d0,a1
        lsl.l   d3,d4
        add.l   way(sp),d4
        lsr.l   #8,d4
        lsr.l   #3,d4
        addq.l  #2,d4
        steps   \1,\2
        move.l  mask(sp),d0
        sub.l   d0,d4
        subq.l  #1,d4
        and.l   d0,d4                   ; up to a multiple of 1 << cut
.found\1
        move.l  d4,texturing+texturing_\1(a6)
        endm

; How far v of a pixel may be outside the vertices' range, in 1/1024 texel. Edges are within 1/64 pixel
; along a line, at less than 8 texels a pixel: 128. Four cuts by clipping move vertices by 1/2^17 pixel
; each, in x or in y: 1. Steps are off by 1/2^17, over 1,024 pixels in x and in y: 16; v is raised by as
; much: 16. Gradients, 1/2^26 over 4,096 pixels, as much again, and 4 units: 1. Corners beyond three may
; be off the plane by 1/64: 16. The sum is 178; MARGIN is 256.
MARGIN          equ     1<<14

; On the stack:
mask            equ     0               ; -(1 << cut)
limit           equ     4               ; of a numerator's upper half
ways            equ     8               ; the pixels from (i, j) to the box's farthest sides, x and y
                                        ; added, times half a unit of a step in 2^-27
way             equ     12              ; twice the pixels from the first vertex to the farthest one
vectors         equ     16
chain           equ     vectors+2*16
size            equ     chain+4

; texturing_gentle - the plane of a polygon, relative to the first pixel on its left side
;
; in:      a6  setup*  the polygon, with sides of an area that is not 0, box and edges; the cuts of
;                      its texturing are set: 0 to 8, 0 for a chain
;          d1  int32   enum chain
; out:     d0  int32   POLYGON_DRAWN
; trashes: d1-d7/a0-a5
; reads:   sides and their vertices, box, left edges, u_cut, v_cut
; writes:  texturing except v_cut; u_cut if the chain needs a bit; with CHAIN_SHADES v and its steps
;          are 0; u, v, du, dv of the left edges as texturing_starts
; formats: as texturing_plane, but with gradients in 5.27, and (i, j) is the first pixel right of the
;          left side. It does all the work itself if gradients are below 8 texels a pixel, twice the
;          area is 1/2 to 2^20 square pixels, and the top vertex is within 1,024 pixels of (i, j), in
;          x and in y. texturing_plane and texturing_starts do it otherwise. u is raised by the most
;          that it may be below the plane at any pixel of the box. v does not wrap if MARGIN around
;          the range of its vertices is between two multiples of 256
; error:   of a gradient: e = 2 / 2^27 texels a pixel: D keeps 31 bits (cut: 1 in 2^30 of 8
;          texels), the quotient is cut. Raised by half of 1 << cut units a pixel over the box, by e
;          over the way from the first vertex to the farthest pixel, by 1 for the two products and by
;          1 for rounding up
; cost:    about 1,700 cycles with a cold cache, 900 for CHAIN_SHADES
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
; cost:    about 1,500 cycles with a cold cache, 700 for CHAIN_SHADES
        routine texturing_gentle_from
        movea.l edges+edge_plan_left(a6),a0
        move.l  edge_x(a0),d2
        sub.l   #EDGE_BIAS,d2
        move.l  box+rectangle_top(a6),d3
        movem.l d2-d3,texturing+texturing_i(a6)         ; and j
        distance d2,d4,a4
        distance d3,d5,a5
        move.l  box+rectangle_right(a6),d0
        sub.l   d2,d0
        sub.l   box+rectangle_left(a6),d2
        cmp.l   d2,d0
        bge.s   .farther
        move.l  d2,d0
.farther
        add.l   box+rectangle_bottom(a6),d0
        sub.l   d3,d0
        add.l   d0,d4
        add.l   d5,d4
        addq.l  #2,d4
        add.l   d4,d4
        moveq   #10,d1
        lsl.l   d1,d0
        move.l  d4,-(sp)
        move.l  d0,-(sp)

        move.l  sides+sides_area+number64_hi(a6),d0
        move.l  sides+sides_area+number64_lo(a6),d7
        bfffo   d0{0:32},d5
        move.l  d7,d1
        rol.l   #3,d1
        and.w   #7,d1
        move.l  d0,d4
        lsl.l   #3,d4
        or.w    d1,d4                   ; D >> 29
        moveq   #12,d1
        cmp.l   d1,d5
        blo     .large
        moveq   #4,d1
        cmp.l   d1,d4
        blo     .large
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

        move.l  chain(sp),d0
        subq.l  #CHAIN_SHADES,d0
        beq     .shades
        axis    v,t
        move.l  chain(sp),d0
        beq.s   .whole
        subq.l  #CHAIN_ANYWHERE,d0
        beq     .wraps
        movea.l sides+sides_first(a6),a0
        movea.l sides+sides_last(a6),a1
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
        cmpa.l  a1,a0
        bne.s   .vertex
        sub.l   #MARGIN,d0
        add.l   #MARGIN,d1
        eor.l   d0,d1
        cmp.l   #1<<24,d1
        bhs     .wraps
.whole  clr.l   texturing+texturing_wraps(a6)
        clr.l   texturing+texturing_wrap_bit(a6)
.u      axis    u,s
        move.l  texturing+texturing_wrap_bit(a6),d0
        or.l    d0,texturing+texturing_u(a6)
        lea     size(sp),sp

        movea.l edges+edge_plan_left(a6),a1
        move.l  edge_whole(a1),d4
        lea     texturing(a6),a0
        start_step u
        move.l  texturing_u(a0),edge_u(a1)
        start_step v
        move.l  texturing_v(a0),edge_v(a1)
        move.l  edges+edge_plan_lefts(a6),d0
        subq.l  #1,d0
        beq.s   .done
        lea     edge_sizeof(a1),a1
        jsr     texturing_starts
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

.steep  addq.l  #8,sp
.large  addq.l  #8,sp
.far    lea     2*16(sp),sp
        move.l  (sp)+,d1
        beq.s   .unchained
        clr.l   texturing+texturing_u_cut(a6)
.unchained
        lea     texturing(a6),a0
        lea     sides(a6),a1
        move.l  a6,d0
        add.l   #box,d0
        jsr     texturing_plane
        lea     texturing(a6),a0
        movea.l edges+edge_plan_left(a6),a1
        move.l  edges+edge_plan_lefts(a6),d0
        jsr     texturing_starts
        bra     .done
