; Parts of reciprocal_lines and logarithm_lines; they use their registers, labels and stack.

        include "number.i"

; Writes a line's left and n to the struct \1 at a1 and finds q at its ends: d3 of the first
; pixel, d2 of the last, d4 the larger, d5 the smaller; d7 = d4's leading zeros, d6 = n. Goes to
; .next if the line has no pixel, to .other if d5 is below q_low or d7 above \2.
ends_sorted macro
        moveq   #0,d7
        moveq   #0,d6
        move.w  scanline_left(a0),d7
        move.w  scanline_last(a0),d6
        move.w  d7,\1_left(a1)
        sub.w   d7,d6
        move.w  d6,\1_n(a1)
        bmi     .next
        sub.l   a4,d7
        movem.l perspective_plan_q+screen_plane_dx(a5),d4-d5
        move.l  d5,d1
        mulu.l  d7,d0:d1
        muls.l  d4,d7
        add.l   d7,d0
        add.l   row_q+number64_lo(sp),d1
        move.l  row_q(sp),d3
        addx.l  d0,d3
        mulu.l  d6,d2:d5
        muls.l  d6,d4
        add.l   d4,d2
        add.l   d1,d5
        addx.l  d3,d2
        move.l  d2,d4
        move.l  d3,d5
        cmp.l   d4,d5
        ble.s   .sorted\@
        exg     d4,d5
.sorted\@
        cmp.l   perspective_plan_q_low(a5),d5
        blt     .other
        bfffo   d4{0:32},d7
        cmp.w   #\2,d7
        bhi     .other
        endm

; Empties those of the d1 lines from a0 on that are taken, i.e. n of their struct \1 (from a1 on)
; is not negative, so that other routines skip them. Uses d2.
empty_taken macro
.empty\@
        tst.w   \1_n(a1)
        bmi.s   .keep\@
        move.w  scanline_left(a0),d2
        subq.w  #1,d2
        move.w  d2,scanline_last(a0)
.keep\@ lea     scanline_sizeof(a0),a0
        lea     \1_sizeof(a1),a1
        subq.l  #1,d1
        bne.s   .empty\@
        endm

; \1 = \1 * 3/2; sets V if it does not fit. \2: lsr or asr. Uses \3.
three_halves macro
        move.l  \1,\3
        \2.l   #1,\3
        add.l   \3,\1
        endm

; Turns q of an end, \1, into the table's index (lower word) and its fraction (upper word);
; \2 = r there. \3: the line's field that keeps them, if given.
look_up macro
        sub.l   #ORIGIN,\1
        swap    \1
        ifnb    \3
        move.l  \1,reciprocal_line_\3(a1)
        endc
        moveq   #0,\2
        move.w  (a3,\1.w*2),\2
        endm

; Finds the constants that all lines of the scale d7 share. Uses d0-d1/d4-d5.
scale_made macro
        move.w  d7,scale(sp)
        moveq   #15,d1
        and.w   d7,d1                   ; the shift
        move.w  reciprocal_plan_piece+2(a6),d5
        move.w  d1,d0
        addq.w  #5,d0
        sub.w   d5,d0
        move.w  d7,d4
        and.w   #$8000,d4
        or.w    d4,d0
        move.w  d0,scale_c(sp)
        add.w   d5,d1
        movem.l perspective_plan_q+screen_plane_dx(a5),d0/d4
        asl.l   d1,d0
        bvs.s   .coarse
        neg.w   d1
        add.w   #32,d1
        lsr.l   d1,d4
        or.l    d4,d0
        tst.w   d7
        bpl.s   .step
        three_halves d0,asr,d1
        bvs.s   .coarse
.step   move.l  d0,d1
        swap    d1
        move.l  d1,scale_dq(sp)
        move.w  #$7fff,d1
        tst.l   d0
        minus   <neg.l d0>
        cmp.l   #8<<16,d0
        bhs.s   .enough
.coarse moveq   #1,d1
        lsl.w   d5,d1
.enough move.w  d1,scale_far(sp)
        endm

; Writes the line's C of \1, u or v, and \1 at its first pixel. In: d3 = r of that pixel,
; d4 = a quarter of the sum of both ends' r, d7 = the shift of C, \2 = 256 K, a5 = half of
; C's unit. Out: d6 = C. Uses d1-d2.
constant macro
        move.l  row_c\1(sp),d1
        asl.l   d7,d1
        bvs     .too_far
        tst.w   d7
        bmi     .more_\1
.scaled_\1
        move.l  d1,d6
        add.l   a5,d6
        bvs     .too_far
        swap    d6
        move.w  d6,reciprocal_line_c\1(a1)
        ext.l   d6
        muls.w  d4,d1                   ; C's rounding error, in the line's middle
        add.l   d1,d1
        swap    d1
        ext.l   d1
        move.l  d3,d2
        muls.l  d6,d2
        add.l   d2,d1
        move.w  reciprocal_plan_piece+2(a6),d2
        lsl.l   d2,d1
        add.l   \2,d1
        move.l  d1,reciprocal_line_\1(a1)
        endm

; C * 3/2; placed after the loop.
constant_more macro
.more_\1
        three_halves d1,asr,d6
        bvc     .scaled_\1
        bra     .too_far
        endm

; d1 = the amount added to u's steps: half a unit, less the unit that v borrows if it
; falls. In: d6 = C of v, a2 = the growth of r. Out: d6 = |C|. Uses d2-d3.
carry_of_u macro
        moveq   #127,d1
        addq.w  #1,d1
        move.l  d6,d2
        beq.s   .cv
        minus   <neg.l d6>
        move.l  a2,d3
        beq.s   .cv
        eor.l   d3,d2
        bpl.s   .cv
        neg.w   d1
.cv
        endm
