        include "logarithm_lines.i"

; On the stack: q at the line's first possible pixel; for u and v each: 64 C there, its step
; from line to line, K plus half a unit of 8.8; lines left, lines not taken.
row_q   equ     0
row_u   equ     8
row_v   equ     28
row_lines equ   48
row_others equ  52
row_tables equ  56
; Constants of a scale of q, which is a shift and a factor in sixteenths: q's step a pixel, and
; the scale's part of log2 |C|.
scale   equ     60
scale_dq equ    62
scale_base equ  66
row_to  equ     70
row_sizeof equ  74

LEAST   equ     (LOGARITHM_LOWEST+1)<<16
ORIGIN  equ     LOGARITHM_ORIGIN<<16
BIAS    equ     7                       ; parts are on chords, up to 11.5 too low, and are cut

; Values that the first loop keeps for the second.
line_base equ   logarithm_line_power_u  ; the scale's part
line_high equ   logarithm_line_power_v  ; the smaller q's logarithm

; logarithm_lines - prepares each line for spans by logarithms
;
; in:      a0  reciprocal_plan*   the planes, the constants
;          a1  logarithm_tables*  the tables
;          d0  logarithm_line*    where to write the lines
; out:     d0  int32              how many lines are not taken, for other routines to draw
; reads:   the plan except the fields of pieces, its planes, left and last of its lines, logs
;          and parts of the tables
; writes:  count logarithm_lines; if some are not taken, last of the lines that are, so
;          that other routines find these empty
; formats: q.hi of both ends is shifted left, at most 8 bits, until the larger is 2^31 or
;          more, and multiplied by the sixteenths, 16 to 31, that just fit: the larger index
;          is 59,000 or more. log2 |C|, 2^-14 octave, is rounded; K is moved by that error
;          in the middle of the line. Logarithms below the one with which no pixel is 1/32
;          texel from K become that one, and K is moved likewise. A line is not taken if q is
;          below the plan's least, w differs 7 times or more, or a pixel is too far from K
;          for an error of 1/32 texel
; error:   in units of 2^-16 texel, E texels being the farthest from K and i the smaller
;          q's index: E (35390 / i + 1.9), of K and powers 256, else 24; of a line that
;          is 1/32 texel from K at most 968 and these 280

; Errors of an index: 1/2 by its cut, 1/25 by q.hi's shift (1/128), the factor (1/2000) and 1023
; steps (half a unit of rounding and one of overflow each). Errors of a logarithm: 0.505 by its
; rounding, 0.14 by C's rounding less K's move, 0.04 by C itself. The move is 0.72 of the error
; that C's rounding makes at the farthest pixel, up to 1/16 more by a mantissa on a chord: the
; excess elsewhere is less than the gain there. Else: C and K by reciprocal_find (19), K and its
; move cut. 968: 7/16 of 1/32 texel, and 72 by chords.

        routine logarithm_lines,a0,a1,d0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l a0,a6
        movea.l reciprocal_plan_planes(a6),a5
        lea     -row_sizeof(sp),sp
        move.l  a1,row_tables(sp)
        movea.l logarithm_tables_logs(a1),a3
        movea.l d0,a1
        move.l  d0,row_to(sp)
        movem.l reciprocal_plan_cu(a6),d0-d7
        movem.l d0-d1,row_u(sp)
        movem.l d2-d3,row_v(sp)
        movem.l d4-d5,row_u+8(sp)
        movem.l d6-d7,row_v+8(sp)
        movem.l reciprocal_plan_ku(a6),d0-d1
        moveq   #64,d2
        add.l   d2,d2
        add.l   d2,d0
        add.l   d2,d1
        move.l  d0,row_u+16(sp)
        move.l  d1,row_v+16(sp)
        movem.l perspective_plan_q+screen_plane_at(a5),d0-d1
        movem.l d0-d1,row_q(sp)
        move.l  perspective_plan_count(a5),row_lines(sp)
        clr.l   row_others(sp)
        clr.w   scale(sp)
        lea     .factors(pc),a2
        movea.l perspective_plan_lines(a5),a0
        movea.l perspective_plan_left(a5),a4
        lea     EDGE_BIAS(a4),a4

        ; Two loops, so that each fits the cache. First q:
        ; d2, d3 q of the last and the first pixel  d4, d5 the larger and the smaller
        ; d6 n  d7 shift  a2 factors
.line   ends_sorted logarithm_line,LOGARITHM_FURTHEST
        lsl.l   d7,d4
        bfextu  d4{1:5},d4
        move.b  (a2,d4.w),d4
        move.l  d5,d2
        sub.l   d3,d2
        scaled  d3
        tst.l   d2
        beq.s   .first
        scaled  d5
        bra.s   .scaled
.first  move.l  d3,d5
.scaled cmp.l   #LEAST,d5
        blo     .other
        lsl.w   #8,d7
        move.b  d4,d7
        cmp.w   scale(sp),d7
        bne     .scale
.same   move.l  scale_dq(sp),logarithm_line_dq(a1)
        move.l  scale_base(sp),line_base(a1)
        move.l  #ORIGIN,d4
        sub.l   d4,d3
        swap    d3
        move.l  d3,logarithm_line_q(a1)
        sub.l   d4,d5
        swap    d5
        move.w  (a3,d5.w*2),line_high(a1)
.next   next    row_q,perspective_plan_q+screen_plane_dy,a5
        lea     scanline_sizeof(a0),a0
        lea     logarithm_line_sizeof(a1),a1
        subq.l  #1,row_lines(sp)
        bne     .line

        ; Then C and K: a0 parts  a2 the scale's part  a3 limits  a4 the line's limit
        ; a5 the row of u or v  d5 the higher logarithm
        move.l  perspective_plan_count(a5),row_lines(sp)
        movea.l row_to(sp),a1
        movea.l row_tables(sp),a0
        lea     logarithm_tables_parts(a0),a0
        lea     .limits(pc),a3
.second lea     row_u(sp),a5
        tst.w   logarithm_line_n(a1)
        bmi     .skip
        movea.l line_base(a1),a2
        move.w  line_high(a1),d5
        move.w  d5,d0
        ext.l   d5
        add.w   #3*LOGARITHM_OCTAVE/2,d0
        bfextu  d0{16:6},d0
        movea.l (a3,d0.w*4),a4
        bsr.s   .constant
        move.l  d0,logarithm_line_power_u(a1)
        move.w  d2,logarithm_line_u(a1)
        and.w   #1,d6
        move.w  d6,logarithm_line_way(a1)
        bsr.s   .constant
        move.l  d0,logarithm_line_power_v(a1)
        move.w  d2,logarithm_line_v(a1)
        and.w   #2,d6
        or.w    d6,logarithm_line_way(a1)
.done   lea     logarithm_line_sizeof(a1),a1
        subq.l  #1,row_lines(sp)
        bne.s   .second
        bra     .empty_others

; d0 = the power and d2 = K, 8.8, of the row a5, which moves to the next row; d6 = C's sign.
; Uses d1/d3/d7.
.constant
        step_c
        move.l  (a5)+,d2
        tst.l   d0
        smi     d6
        minus   <neg.l d1>,<negx.l d0>
        bfffo   d0{0:32},d7
        beq.s   .none
        moveq   #32,d3
        sub.l   d7,d3
        lsl.l   d7,d0
        lsr.l   d3,d1
        or.l    d1,d0
        bfextu  d0{1:8},d3
        bfextu  d0{9:16},d1
        move.l  (a0,d3.w*4),d0
        move.l  4(a0,d3.w*4),d3
        sub.l   d0,d3
        mulu.w  d1,d3
        clr.w   d3
        swap    d3
        add.l   d3,d0
        swap    d7
        lsl.l   #6,d7
        sub.l   d7,d0
        add.l   a2,d0                   ; in 1/256 units
        move.l  d0,d7
        asr.l   #8,d7
        move.l  d7,d3
        add.l   d5,d3
        cmp.l   a4,d3
        bgt.s   .too_far
        cmp.l   #LOGARITHM_LEAST,d3
        blt.s   .small
        mantissa d3,d1
        swap    d1                      ; the farthest pixel, 1/64 texel
        eor.b   #$80,d0
        ext.w   d0                      ; the rounding error
        muls.w  d1,d0
        lsl.l   #3,d0
        swap    d0                      ; 2^-13: 0.72 of the exact 1,024 ln 2 / OCTAVE / 256 units
        ext.l   d0
.move   tst.b   d6
        beq.s   .moved
        neg.l   d0
.moved  add.l   d0,d2
        asr.l   #8,d2
        move.l  d7,d0
        add.l   d0,d0
        rts

        ; All of the line is within 1/32 texel of K.
.none   moveq   #-1,d3
.small  move.l  #LOGARITHM_LEAST,d7
        sub.l   d5,d7
        moveq   #8,d1                   ; 1/4096 texel
        tst.l   d3
        bmi.s   .tiny
        mantissa d3,d1
        lsr.l   #8,d1
        lsr.l   #2,d1
.tiny   move.l  d1,d0
        sub.w   #128,d0
        move.l  d0,d1
        ext.l   d0
        lsl.l   #3,d0
        ext.l   d1
        add.l   d1,d0                   ; 9/16, the middle of 1 and 1/8
        bra.s   .move

.too_far
        addq.l  #4,sp
        addq.l  #1,row_others(sp)
        move.w  #-1,logarithm_line_n(a1)
        lea     row_v(sp),a4
        cmpa.l  a4,a5
        bne     .done                   ; it was v
        step_c
        bra     .done
.skip   step_c
        addq.l  #4,a5
        step_c
        bra     .done

.empty_others
        move.l  row_others(sp),d0
        beq.s   .all
        movea.l reciprocal_plan_planes(a6),a5
        movea.l perspective_plan_lines(a5),a0
        move.l  perspective_plan_count(a5),d1
        movea.l row_to(sp),a1
        empty_taken logarithm_line
.all    lea     row_sizeof(sp),sp
        movem.l (sp)+,d2-d7/a2-a6
        rts

.other  addq.l  #1,row_others(sp)
        move.w  #-1,logarithm_line_n(a1)
        bra     .next

.scale  scale_found
        bra     .same

; The sixteenths with which q still fits, by its upper 6 bits, 32 to 63.
.factors
        rept    32
        dc.b    1024/(REPTN+33)
        endr

; log2 of 256 E by sixteenths of an octave of the higher logarithm. E is the distance from K, in
; texels, at which the error is 1/32 texel; almost 512 at most, as a rounded step may move an
; index 3 units further.
        cnop    0,4
.limits
        dc.l    278524,278524,278524,278524,278524,278524,278524,278524
        dc.l    278524,278524,278524,278524,278524,278524,278524,278524
        dc.l    278524,278524,278524,278524,278524,278524,278524,278524
        dc.l    278247,277774,277290,276795,276289,275772,275243,274704
        dc.l    274153,273592,273019,272436,271842,271237,270621,269995
        dc.l    269358,268711,268054,267386,266709,266021,265324,264617
