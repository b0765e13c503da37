; The planes of texturing_gentle: a6 is the setup.

        include "routine.i"

texturing       equ     setup_texturing
edges           equ     setup_edges
sides           equ     setup_sides
box             equ     setup_box

; The longest way to the box's farthest sides, pixels in x and y added. With a cut of 0 or 1, values are
; off by less than 1/128 texel, 512 units: by a unit a pixel at most, raised by as much, and 12 more.
WAYS_MOST       equ     240

; Units by which a value is raised beside its steps: gradients are off by 2.5 / 2^26 over less than 1,270
; pixels from the first vertex, 3.1 units; both products by half of one, halving ways by as much.
RAISED          equ     5

; On the stack:
mask            equ     0               ; -(1 << cut)
ways            equ     4               ; pixels from (i, j) to the box's farthest sides, x and y added
vectors         equ     8
chain           equ     vectors+2*16
size            equ     chain+4

; d0 = (p1 q2 - p2 q1) / D in 6.26; p, q: the fields \1, \2. Goes to .handed if it may be 16 or more. d7 =
; (2^61 - 1) / D, D with 31 bits; d5 = the left shift of the numerator that belongs to it, d6 = 32 - d5.
; a2, a3: the two vectors from the first vertex. Uses d1-d3.
gradient macro
        move.l  \1(a2),d1
        muls.l  \2(a3),d0:d1
        move.l  \1(a3),d3
        muls.l  \2(a2),d2:d3
        sub.l   d3,d1
        subx.l  d2,d0
        asl.l   d5,d0
        bvs     .handed
        lsr.l   d6,d1
        or.l    d0,d1
        muls.l  d7,d0:d1
        endm

; Adds the gradient d0 times the distance \1 to d4, rounded to the nearest. Uses d1-d2.
rise    macro
        move.l  \1,d1
        muls.l  d0,d2:d1                ; 16.48
        add.l   d1,d1                   ; half a unit
        addx.l  d2,d4
        endm

; Puts the gradient d0 into the field \1 as a step, rounded to the nearest multiple of 1 << cut
; units, a1 being half of that. \2: "whole" if cut is 0. Uses d0-d1.
step    macro
        add.l   a1,d0
        moveq   #10,d1
        asr.l   d1,d0
        ifc     '\2',''
        and.l   mask(sp),d0
        endc
        move.l  d0,texturing+texturing_\1(a6)
        endm

; Finds \1, u or v, and its steps from the plane of \2, s or t. a1, d4: half of 1 << cut, and twice
; what steps that are off by as much make over the ways. \3: as step.
steps   macro
        lsr.l   #1,d4
        addq.l  #RAISED,d4
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
        movea.w #1<<9,a1
        move.l  texturing+texturing_\1_cut(a6),d3
        bne     .cut\1
        steps   \1,\2,whole
        bra     .found\1
.cut\1 moveq   #-1,d0
        lsl.l   d3,d0
        move.l  d0,mask(sp)
        move.l  a1,d0
        lsl.l   d3,d0
        movea.l d0,a1
        lsl.l   d3,d4
        steps   \1,\2
        move.l  mask(sp),d0
        sub.l   d0,d4
        subq.l  #1,d4
        and.l   d0,d4                   ; up to a multiple of 1 << cut
.found\1
        move.l  d4,texturing+texturing_\1(a6)
        endm
