; Lines of one depth each: what level_reciprocal keeps on the stack, and its arithmetic in 64 bits.

        include "chain.i"

INVERSE_FAST equ 1<<22                  ; v of a pixel, 64 texels
INVERSE_STEEP equ 1<<20                 ; of the upper half of ds/dx: 2^11 pixels of it fit 64 bits
INVERSE_RAISE equ 3                     ; units, of what is cut
INVERSE_HIGH equ perspective_plan_u_high-perspective_plan_u

; Of u or v.
inverse_k equ   0                       ; with the plan's base and INVERSE_RAISE
inverse_c equ   4                       ; 64 bits, at the plan's left
inverse_step equ 4                      ; then: of C to the next line, if it is `whole` pixels further right,
inverse_more equ 8                      ; and if it is one more
inverse_dc equ  12
inverse_part equ 16

; On the stack.
inverse_u equ   0
inverse_v equ   inverse_part
inverse_far equ 2*inverse_part          ; q of the farthest line at the plan's left, 64 bits
inverse_dq equ  inverse_far             ; then: q's growth a line, 48.16 in the upper bits
inverse_sign equ inverse_far+8          ; of q's growth
inverse_whole equ inverse_sign
inverse_most equ inverse_sign+4         ; of the upper halves of C, less their signs
inverse_up equ  inverse_most            ; then: what is added to steps of u
inverse_q equ   inverse_most+4          ; of the first line, 64 bits; then: 48.16, as above
inverse_up_v equ inverse_q+8            ; and of v: 1, or 0 if v does not change along lines
inverse_sizeof equ inverse_up_v+4

; Adds the field \1 of the plane a5, times \2, to d0:d1. Uses d2-d3.
line_up macro
        tst.l   \2
        beq.s   .here\@
        move.l  \1(a5),d2
        muls.l  \2,d2
        add.l   d2,d0
        move.l  \1+number64_lo(a5),d3
        mulu.l  \2,d2:d3
        add.l   d3,d1
        addx.l  d2,d0
.here\@
        endm

; Keeps the most of the upper halves of C, less their signs, of d0.
fitting macro
        tst.l   d0
        minus   <not.l d0>
        cmp.l   inverse_most(a4),d0
        bls.s   .less\@
        move.l  d0,inverse_most(a4)
.less\@
        endm

; \2 = the 64 bits at \1 shifted right by d5, plus 1; d6 = 32 - d5. Uses d0-d1.
shifted macro
        movem.l \1,d0-d1
        lsl.l   d6,d0
        move.l  d1,\2
        lsr.l   d5,\2
        or.l    d0,\2
        addq.l  #1,\2
        endm

; The steps of C of \1, u or v, to lines d6 pixels further right, from \2 = dC, and C = \3 of the first of them.
; Uses d4.
turned  macro
        move.l  \2,d4
        muls.l  d6,d4
        add.l   d4,\3
        move.l  d4,inverse_\1+inverse_step(sp)
        add.l   \2,d4
        move.l  d4,inverse_\1+inverse_more(sp)
        endm
