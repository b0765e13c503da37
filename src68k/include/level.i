; Lines and columns of nearly constant depth: their first pixels and steps from the planes of q, s and t.

        include "chain.i"
        include "perspective.i"

STEP_SIGN equ   23                      ; of v's step modulo 256 texels

; On the stack, behind the walk.
taken_u equ     walk_sizeof             ; what the range takes from u of the line's first pixel
taken_v equ     walk_sizeof+4
lines_end equ   walk_sizeof+8
chain_bit equ   walk_sizeof+12          ; of v's step: if it is set, u's is a unit more
step_u  equ     walk_sizeof+16
step_v  equ     step_u+12
level_sizeof equ step_v+12

; A step of lines without tilt: the polygon's gradient, less 1 if it is above 0, so that its quotient, cut towards
; zero, and `up`, 1 or 0, are the quotient rounded up.
step_hi equ     0
step_lo equ     4
step_up equ     8

; Steps the walk to the line a0: d2-d5 = s and t, d0 = q.hi of its first pixel, a4 its x, a5 the next line's if the
; side goes on as it does. Goes to .empty\1 if the line has no pixels. Uses d6/a2.
advance macro
        movea.w scanline_left(a0),a4
        move.l  a4,d6
        sub.l   a5,d6
        lea     walk_steps(sp),a2
        beq.s   .step\1
        lea     walk_more-walk_steps(a2),a2
        subq.l  #1,d6
        bne     .turn\1
.step\1 move.l  number64_lo(a2),d6
        add.l   d6,walk_q+number64_lo(sp)
        move.l  (a2),d6
        ifne    \1
        move.l  walk_q(sp),d0
        endc
        addx.l  d6,d0
        ifne    \1
        move.l  d0,walk_q(sp)
        endc
        walk_add walk_s,d2,d3
        walk_add walk_t,d4,d5
        movea.l a4,a5
        adda.l  walk_whole(sp),a5
        cmpa.w  scanline_last(a0),a4
        bgt     .empty\1
        endm

; The routines that make the step at a1 of the gradient at a0, by d0-d2, and turn the walk by d6 pixels at a vertex.
level_calls macro
level_make
        movem.l (a0),d0-d1
        move.l  d0,d2
        bmi.s   .falls
        or.l    d1,d2
        beq.s   .made
        moveq   #1,d2
        sub.l   d2,d1
        bcc.s   .made
        subq.l  #1,d0
        bra.s   .made
.falls  moveq   #0,d2
.made   movem.l d0-d2,(a1)
        rts

level_turn
        movem.l d0-d5,-(sp)
        lea     7*4(sp),a2              ; behind the caller's place
        move.l  d6,d0
        bsr     walk_turn
        movem.l (sp)+,d0-d5
        rts
        endm

; \4 = \1, u or v, of the line's first pixel less its base: \2:\3 / d1, cut towards zero, held in the range. A
; quotient of more than 32 bits sets V, or is 0 in FS-UAE. Uses d6-d7.
start   macro
        move.l  \2,d6
        move.l  \3,d7
        divs.l  d1,d6:d7
        bvs     .far_\1\5
        beq     .zero_\1\5
.fits_\1\5
        cmp.l   perspective_plan_\1_low(a6),d7
        blt     .low_\1\5
        cmp.l   perspective_plan_\1_high(a6),d7
        bgt     .high_\1\5
.held_\1\5
        movea.l d7,\4
        endm

; Holds the first pixel's \1. If more than its end is taken, and as much fits a long, that is kept and the loop left
; behind this line.
hold    macro
.high_\1\3
        sub.l   perspective_plan_\1_high(a6),d7
        move.l  d7,taken_\1(sp)
        lea     scanline_sizeof(a0),a3
.most_\1\3
        move.l  perspective_plan_\1_high(a6),d7
        bra     .held_\1\3
.zero_\1\3
        move.l  \2,d6
        minus   <not.l d6>
        beq     .fits_\1\3
.far_\1\3
        tst.l   \2
        bpl.s   .most_\1\3
.low_\1\3
        move.l  perspective_plan_\1_low(a6),d7
        bra     .held_\1\3
        endm

; d7 = the step of \1 on a line without tilt. Uses d6.
level_step macro
        movem.l step_\1(sp),d6-d7
        divs.l  d1,d6:d7
        bvs     .over_\1
        beq     .none_\1
.fit_\1 add.l   step_\1+step_up(sp),d7
.step_\1
        endm

; Steps of more than 32 bits are 0: the line has a pixel or two.
over    macro
.none_\1
        move.l  step_\1+step_hi(sp),d6
        minus   <not.l d6>
        beq     .fit_\1
.over_\1
        moveq   #0,d7
        bra     .step_\1
        endm

; d7 = the step of \1 on a line with a tilt, its first value less its base in \3: the gradient of the plane \2, s or
; t, less that of q times \3, over q of the last pixel in d1, rounded up; 0 if that does not fit. Uses d0/d6.
tilted_step macro
        move.l  \3,d7
        muls.l  perspective_plan_tilt(a6),d0:d7
        move.b  d0,d7
        ror.l   #8,d7
        asr.l   #8,d0
        sub.l   perspective_plan_\2+screen_plane_dx+number64_lo(a6),d7
        move.l  perspective_plan_\2+screen_plane_dx(a6),d6
        subx.l  d6,d0                   ; less the step, times q
        bmi.s   .rises\@
        neg.l   d7
        negx.l  d0
        divs.l  d1,d0:d7
        bvc.s   .made\@
        bra.s   .over\@
.rises\@
        not.l   d7
        not.l   d0
        move.l  d0,d6
        divs.l  d1,d0:d7
        bvs.s   .over\@
        beq.s   .none\@
.fits\@ addq.l  #1,d7
        bra.s   .made\@
.none\@ tst.l   d6
        beq.s   .fits\@
.over\@ moveq   #0,d7
.made\@
        endm

; Adds q's growth to the line's last pixel to d1. Uses d0/d7.
tilt    macro
        move.w  scanline_last(a0),d7
        sub.w   scanline_left(a0),d7
        ext.l   d7
        muls.l  perspective_plan_tilt(a6),d0:d7
        move.b  d0,d7
        ror.l   #8,d7
        add.l   d7,d1
        cmp.l   perspective_plan_q_low(a6),d1
        bge.s   .held\@
        move.l  perspective_plan_q_low(a6),d1
.held\@
        endm

; The loop over lines up to a3; \1: 1 if they have a tilt, else 0.
lines   macro
.line\1 advance \1
        weight  d1
        start   u,d2,d3,a4,\1
        start   v,d4,d5,a2,\1
        ifeq    \1
        level_step u
        move.l  d7,(a1)+
        level_step v
        else
        tilt
        tilted_step u,s,a4
        move.l  d7,(a1)+
        tilted_step v,t,a2
        endc
        move.l  d7,(a1)+
        and.l   chain_bit(sp),d7
        beq.s   .pack\1
        addq.l  #1,scanline_step_dudx-scanline_step_sizeof(a1)
.pack\1 move.l  a4,d6
        add.l   perspective_plan_u(a6),d6
        move.l  a2,d7
        add.l   perspective_plan_v(a6),d7
        pack_start d6,d7,d1,a0
.next\1 lea     scanline_sizeof(a0),a0
        cmpa.l  a3,a0
        bne     .line\1
        ifeq    \1
        bra     .stop
        endc
        endm

; Parts of the loop that lines seldom reach.
others  macro
.turn\1 bsr     level_turn
        bra     .step\1
        hold    u,d2,\1
        hold    v,d4,\1
        ifeq    \1
        over    u
        over    v
        endc
.empty\1
        addq.l  #scanline_step_sizeof,a1
        bra     .next\1
        endm

; d6 = what each step of the line before a0 and a1 has to make up for in \1; goes to \2 if there is nothing to. Uses
; d7.
regain  macro
        move.l  taken_\1(sp),d6
        beq.s   \2
        clr.l   taken_\1(sp)
        moveq   #0,d7
        move.w  scanline_last-scanline_sizeof(a0),d7
        sub.w   scanline_left-scanline_sizeof(a0),d7
        beq.s   \2
        divu.l  d7,d6
        addq.l  #1,d6
        endm
