; The planes of q, s and t along the sides of a table (see c/span/perspective.h).

        include "routine.i"

; A walk down one side, on the stack: the planes at its last pixel; their steps to the next line's, if that
; is `whole` pixels further right, and if it is one more; x of its last pixel, from the plan's left.
; Between two vertices there are no other steps.
walk_q  equ     0
walk_s  equ     8
walk_t  equ     16
walk_steps equ  24                      ; in this order
walk_more equ   48
walk_x  equ     72
walk_whole equ  76
walk_sizeof equ 80

; Pushes a walk that is on the line above the table. In: a6 plan. Uses d0-d5/a1-a2.
walk_open macro
        lea     -walk_sizeof(sp),sp
        movea.l sp,a2
        lea     perspective_plan_q(a6),a1
        moveq   #3-1,d5
.plane\@
        movem.l (a1)+,d0-d3             ; at, dx
        move.l  d3,walk_more+number64_lo(a2)
        move.l  d2,walk_more(a2)
        move.l  (a1)+,d2                ; dy
        move.l  (a1)+,d3
        move.l  d2,walk_steps(a2)
        move.l  d3,walk_steps+number64_lo(a2)
        sub.l   d3,d1
        subx.l  d2,d0
        add.l   d3,walk_more+number64_lo(a2)
        move.l  walk_more(a2),d4
        addx.l  d2,d4
        move.l  d4,walk_more(a2)
        move.l  d0,(a2)+
        move.l  d1,(a2)+
        dbra    d5,.plane\@
        clr.l   walk_x(sp)
        clr.l   walk_whole(sp)
        endm

; d0:d1, d2:d3, d4:d5 = q, s, t at pixel d7 of the next line of the walk \1(sp). Uses d6/a2.
walk_to macro
        move.l  d7,d0
        sub.l   \1+walk_x(sp),d0
        move.l  d7,\1+walk_x(sp)
        lea     \1+walk_steps(sp),a2
        sub.l   \1+walk_whole(sp),d0
        beq.s   .step\@
        lea     walk_more-walk_steps(a2),a2
        subq.l  #1,d0
        beq.s   .step\@
        lea     \1(sp),a2
        bsr     walk_turn
.step\@ movem.l \1(sp),d0-d5
        walk_add 0,d0,d1
        walk_add 8,d2,d3
        walk_add 16,d4,d5
        movem.l d0-d5,\1(sp)
        endm

; Adds the number \1(a2) to \2:\3. Uses d6.
walk_add macro
        add.l   \1+number64_lo(a2),\3
        move.l  \1(a2),d6
        addx.l  d6,\2
        endm

; The routine that walk_to calls at vertices: the walk a2 goes d0 pixels further right than `more` does.
; a2 = its new steps. Uses d0-d6.
walk_turns macro
walk_turn
        addq.l  #1,d0
        add.l   d0,walk_whole(a2)
        lea     walk_more(a2),a2
        move.l  a1,-(sp)
        lea     perspective_plan_q+screen_plane_dx(a6),a1
        moveq   #3-1,d6
.plane  move.l  number64_lo(a1),d2
        move.l  d0,d3
        mulu.l  d2,d4:d3                ; of d0 as an unsigned number
        tst.l   d0
        bpl.s   .right
        sub.l   d2,d4
.right  move.l  (a1),d5
        muls.l  d0,d5
        add.l   d5,d4
        add.l   number64_lo+walk_steps-walk_more(a2),d3
        move.l  walk_steps-walk_more(a2),d5
        addx.l  d5,d4
        move.l  d4,walk_steps-walk_more(a2)
        move.l  d3,number64_lo+walk_steps-walk_more(a2)
        add.l   d2,d3
        move.l  (a1),d5
        addx.l  d5,d4
        move.l  d4,(a2)+
        move.l  d3,(a2)+
        lea     screen_plane_sizeof(a1),a1
        dbra    d6,.plane
        movea.l (sp)+,a1
        lea     walk_steps-walk_more-24(a2),a2
        rts
        endm

; d1 = d0:d1 / \2, cut towards zero and clamped to the range of \1, u or v. Uses d0/d2. A
; comparison finds quotients that do not fit 32 bits, except for the last bit, which V
; shows: FS-UAE gives 0 without V from 2^32 on.
quotient macro
        move.l  d0,d2
        minus   <not.l d2>
        add.l   d2,d2
        cmp.l   \2,d2
        bhs.s   .far\@
        divs.l  \2,d0:d1
        bvs.s   .far\@
        cmp.l   perspective_plan_\1_low(a6),d1
        blt.s   .low\@
        cmp.l   perspective_plan_\1_high(a6),d1
        ble.s   .inside\@
.high\@ move.l  perspective_plan_\1_high(a6),d1
        bra.s   .inside\@
.far\@  tst.l   d0
        bpl.s   .high\@
.low\@  move.l  perspective_plan_\1_low(a6),d1
.inside\@
        endm

; \1 = q's upper half d0, clamped to q_low at least.
weight  macro
        move.l  perspective_plan_q_low(a6),\1
        cmp.l   d0,\1
        bge.s   .held\@
        move.l  d0,\1
.held\@
        endm
