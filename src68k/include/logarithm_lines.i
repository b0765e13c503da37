; Parts of logarithm_lines; they use its registers and its stack.

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

; Scales \1 = q.hi: shifted left by d7 - 4, times the factor d4.
scaled  macro
        lsl.l   d7,\1
        lsr.l   #4,\1
        mulu.l  d4,\1
        endm

; \2 = 2^(\1 / OCTAVE) in 1/OCTAVE, linear between powers of 2. \1 loses its fraction.
mantissa macro
        bfextu  \1{32-LOGARITHM_BITS:LOGARITHM_BITS},\2
        bset    #LOGARITHM_BITS,\2
        bfextu  \1{27-LOGARITHM_BITS:5},\1
        lsl.l   \1,\2
        endm

; d0:d1 = C of the row a5, u's or v's; steps the row to the next line and a5 to its K.
step_c  macro
        movem.l (a5)+,d0-d3
        add.l   d1,d3
        addx.l  d0,d2
        movem.l d2-d3,-16(a5)
        endm

; Finds the constants of a new scale, which the following lines share. d7 is shift:factor, d4
; the factor. Uses d0-d2.
scale_found macro
        move.w  d7,scale(sp)
        movem.l perspective_plan_q+screen_plane_dx(a5),d0-d1
        lsr.l   #4,d1
        move.l  d0,d2
        ror.l   #4,d2
        and.l   #$f0000000,d2
        or.l    d2,d1
        asr.l   #4,d0
        mulu.l  d4,d2:d1
        muls.l  d4,d0
        add.l   d2,d0
        lsr.w   #8,d7
        lsl.l   d7,d0
        move.l  d1,d2
        lsl.l   d7,d1
        neg.w   d7
        add.w   #32,d7
        lsr.l   d7,d2
        or.l    d2,d0
        add.l   d1,d1
        moveq   #0,d1
        addx.l  d1,d0                   ; to the nearest
        swap    d0
        move.l  d0,scale_dq(sp)
        moveq   #32+33,d1
        sub.w   d7,d1                   ; shift + 33
        swap    d1
        lsl.l   #6,d1                   ; octaves, 1/256 units
        sub.l   #(LOGARITHM_MIDDLE<<8)-BIAS-128,d1
        move.l  a0,d2
        movea.l row_tables(sp),a0
        sub.w   #16,d4
        lsl.w   #6,d4
        add.l   logarithm_tables_parts(a0,d4.w),d1
        movea.l d2,a0
        move.l  d1,scale_base(sp)
        endm
