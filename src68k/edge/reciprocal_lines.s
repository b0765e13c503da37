        include "reciprocal_lines.i"

; On the stack: q at the line's first possible pixel, 64 C; lines left, lines not taken.
row_q   equ     0
row_cu  equ     8
row_cv  equ     16
row_lines equ   24
row_others equ  28
; Constants of a scale of q, which is a shift, with bit 15 set if q is also multiplied by 3/2:
; q's step a piece, the shift of C (and bit 15), and the n from which on a line's step is too
; small.
scale   equ     32
scale_dq equ    34
scale_c equ     38
scale_far equ   40
row_sizeof equ  42

TWO     equ     $40000000               ; q below this gets another factor
THREE   equ     $aaaa0000               ; q below this fits 32 bits after * 3/2
LEAST   equ     (RECIPROCAL_LOWEST+2)<<16
ORIGIN  equ     RECIPROCAL_ORIGIN<<16

; reciprocal_lines - prepares each line for spans by reciprocals
;
; in:      a0  reciprocal_plan*  the planes, the constants, where to write the lines
; out:     d0  int32             how many lines are not taken, for other routines to draw
; reads:   the plan, its planes, left and last of its lines, the table
; writes:  count reciprocal_lines; if some are not taken, last of the lines that are, so
;          that other routines find these empty
; formats: q of both ends is shifted left, at most 8 bits, until the larger is 2^31 or more;
;          if the smaller is below 2^30 then, both are multiplied by 3/2 if they fit. C = c
;          2^(shift - piece + 5) / 2^26, 16.16, likewise times 3/2, rounded; K is moved by
;          that error in the middle of the line's r. A line is not taken if q is below the
;          plan's least or the table's (never with w up to 4 times apart, always with 6), r
;          differs too much for 16 bits in less than three pieces, a piece moves q by less
;          than 8 indices or more than 32 bits hold, or |C| r exceeds the plan's limit
; error:   in units of 2^-16 texel, E texels being the farthest from K and i the smaller
;          q's index: of q's index E 32768 / i, of r and C E i / 16384, of C's rounding
;          (r - r') / 2^(10 - piece), else 50
        routine reciprocal_lines,a0
        save_all
        movea.l a0,a6
        movea.l reciprocal_plan_planes(a6),a5
        lea     -row_sizeof(sp),sp
        movem.l perspective_plan_q+screen_plane_at(a5),d0-d1
        movem.l reciprocal_plan_cu(a6),d2-d5
        move.l  perspective_plan_count(a5),d6
        moveq   #0,d7
        movem.l d0-d7,row_q(sp)
        move.w  #-1,scale(sp)
        movea.l perspective_plan_lines(a5),a0
        movea.l reciprocal_plan_to(a6),a1
        movea.l reciprocal_plan_table(a6),a3
        movea.l perspective_plan_left(a5),a4
        lea     EDGE_BIAS(a4),a4

        ; Two loops, so that each fits the cache. First q:
        ; d2, d3 q of the last and the first pixel  d4, d5 the larger and the smaller
        ; d6 n  d7 scale
.line   ends_sorted reciprocal_line,RECIPROCAL_FURTHEST
        lsl.l   d7,d2
        lsl.l   d7,d3
        lsl.l   d7,d4
        lsl.l   d7,d5
        cmp.l   #TWO,d5
        bhs.s   .large
        cmp.l   #THREE,d4
        blo     .half
.as_is  cmp.l   #LEAST,d5
        blo     .other
.large  cmp.w   scale(sp),d7
        bne     .scale
.same   cmp.w   scale_far(sp),d6
        bge     .other
        move.l  scale_dq(sp),reciprocal_line_dq(a1)
        move.w  scale_c(sp),reciprocal_line_scale(a1)
        look_up d3,d0,q
        look_up d2,d1
        move.w  d0,reciprocal_line_first(a1)
        move.w  d1,reciprocal_line_last(a1)
        sub.l   d0,d1                   ; the growth of r
        move.w  d1,d2
        ext.l   d2
        cmp.l   d1,d2
        bne     .steep
.next   next    row_q,perspective_plan_q+screen_plane_dy,a5
        lea     scanline_sizeof(a0),a0
        lea     reciprocal_line_sizeof(a1),a1
        subq.l  #1,row_lines(sp)
        bne     .line

        ; Then C, u and v. a0 the limit  a2 the growth of r  a3, a4 256 K  a5 half of C's unit
        move.l  perspective_plan_count(a5),row_lines(sp)
        movea.l reciprocal_plan_to(a6),a1
        movem.l reciprocal_plan_ku(a6),d0-d1/a0
        lsl.l   #8,d0
        lsl.l   #8,d1
        movea.l d0,a3
        movea.l d1,a4
        movea.l #$8000,a5
.second tst.w   reciprocal_line_n(a1)
        bmi     .done
        moveq   #0,d3
        moveq   #0,d5
        move.w  reciprocal_line_first(a1),d3
        move.w  reciprocal_line_last(a1),d5
        move.w  reciprocal_line_scale(a1),d7
        move.l  d3,d4
        add.l   d5,d4
        lsr.l   #2,d4
        movea.l d5,a2
        suba.l  d3,a2
        cmp.l   d3,d5
        bhs.s   .rises
        move.l  d3,d5                   ; the larger r
.rises  constant u,a3
        move.l  d6,d0
        minus   <neg.l d0>
        constant v,a4
        carry_of_u
        move.w  d1,reciprocal_line_carry(a1)
        cmp.w   d0,d6
        bls.s   .larger
        move.w  d6,d0
.larger mulu.w  d5,d0
        cmp.l   a0,d0
        bhi     .too_far
.done   next    row_cu,reciprocal_plan_dcu,a6
        next    row_cv,reciprocal_plan_dcv,a6
        lea     reciprocal_line_sizeof(a1),a1
        subq.l  #1,row_lines(sp)
        bne     .second

        move.l  row_others(sp),d0
        beq.s   .all
        movea.l reciprocal_plan_planes(a6),a5
        movea.l perspective_plan_lines(a5),a0
        movea.l reciprocal_plan_to(a6),a1
        move.l  perspective_plan_count(a5),d1
        empty_taken reciprocal_line
.all    lea     row_sizeof(sp),sp
        return_all

        constant_more u
        constant_more v
.too_far
        addq.l  #1,row_others(sp)
        move.w  #-1,reciprocal_line_n(a1)
        bra     .done

        ; The growth of r exceeds 16 bits; with three pieces or more that of a piece does not.
.steep  move.w  reciprocal_plan_piece+2(a6),d0
        lsr.w   d0,d6
        subq.w  #3,d6
        bpl     .next
.other  addq.l  #1,row_others(sp)
        move.w  #-1,reciprocal_line_n(a1)
        bra     .next

.half   bset    #15,d7
        three_halves d2,lsr,d1
        three_halves d3,lsr,d1
        three_halves d5,lsr,d1
        bra     .as_is

.scale  scale_made
        bra     .same
