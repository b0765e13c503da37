; The planes of texturing_gentle: a6 is the setup.

        include "routine.i"

texturing       equ     setup_texturing
edges           equ     setup_edges
sides           equ     setup_sides
box             equ     setup_box

; The longest way to the box's farthest sides, pixels in x and y added. With a cut of 0 or 1, values are
; off by less than 1/128 texel, 512 units: by a unit a pixel at most, raised by as much, and 22 more.
WAYS_MOST       equ     240

; On the stack:
mask            equ     0               ; -(1 << cut)
limit           equ     4               ; of a numerator's upper half
ways            equ     8               ; the pixels from (i, j) to the box's farthest sides, x and y
                                        ; added, times half a unit of a step in 2^-27
way             equ     12              ; twice the pixels from the first vertex to the farthest one
vectors         equ     16
chain           equ     vectors+2*16
size            equ     chain+4

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
