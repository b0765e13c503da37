        include "perspective.i"

; On the stack.
left_side equ   0                       ; walks
right_side equ  walk_sizeof
first_q equ     2*walk_sizeof         ; of the line
lines_left equ  2*walk_sizeof+4

; Adds 64 log2(\1) to d2, \1 above 0, by the table \2, which rounds up or down. Uses d0-d1/a2.
logarithm macro
        move.l  \1,d0
        bfffo   d0{0:32},d1
        lsl.l   d1,d0
        bfextu  d0{1:6},d0
        lea     \2(pc),a2
        move.b  (a2,d0.w),d0
        add.w   d0,d2
        eor.w   #31,d1
        lsl.w   #6,d1
        add.w   d1,d2
        endm

; perspective_lines - prepares each line for perspective spans
;
; in:      a0  perspective_plan*  the table, the planes, where to write the lines
; reads:   the plan, left and last of its lines
; writes:  count perspective_lines; of an empty one left and n, of one of a single pixel
;          left, n, u and v
; formats: u = base + s / q.hi, cut towards zero, 16.16, at the first and the last
;          pixel, both clamped to the plan's limits; weights: q.hi of both, shifted
;          left until the larger is in 2^30 to 2^31, divided by n: the first one's is at
;          least 1, the last one's even. enough: 2^(x / 64), by tables that round x up
; error:   u, v: a unit at the ends. A weight: n + 1 in 2^30

; A curve through three points of u = K + C / q, h pixels apart, is off by h^3 |u'''| /
; 15.59 at most, and u''' is 6 du q0 q1 dq^2 / (n q^4) in weights of the ends. As a sum
; of logarithms this gives the least q for each length.

        routine perspective_lines,a0
        save_all
        movea.l a0,a6
        move.l  perspective_plan_count(a6),-(sp)
        subq.l  #4,sp
        walk_open
        walk_open
        movea.l perspective_plan_lines(a6),a0
        movea.l perspective_plan_to(a6),a1
        movea.l perspective_plan_left(a6),a4
        lea     EDGE_BIAS(a4),a4

.line   moveq   #0,d7
        move.w  scanline_left(a0),d7
        move.w  d7,perspective_line_left(a1)
        move.w  scanline_last(a0),d0
        sub.w   d7,d0
        movea.w d0,a3                   ; n
        move.w  a3,perspective_line_n(a1)
        sub.l   a4,d7
        walk_to left_side
        cmpa.w  #0,a3
        blt     .right
        weight  d7                      ; q0
        move.l  d2,d0
        move.l  d3,d1
        quotient u,d7
        add.l   perspective_plan_u(a6),d1
        move.l  d1,perspective_line_u(a1)
        move.l  d4,d0
        move.l  d5,d1
        quotient v,d7
        add.l   perspective_plan_v(a6),d1
        move.l  d1,perspective_line_v(a1)
        move.l  d7,first_q(sp)
.right  move.w  scanline_last(a0),d7
        ext.l   d7
        sub.l   a4,d7
        walk_to right_side
        cmpa.w  #0,a3
        ble     .next
        weight  d6                      ; q1
        move.l  d2,d0
        move.l  d3,d1
        quotient u,d6
        add.l   perspective_plan_u(a6),d1
        sub.l   perspective_line_u(a1),d1
        move.l  d1,perspective_line_du(a1)
        movea.l d1,a5
        move.l  d4,d0
        move.l  d5,d1
        quotient v,d6
        add.l   perspective_plan_v(a6),d1
        sub.l   perspective_line_v(a1),d1
        move.l  d1,perspective_line_dv(a1)
        move.l  d1,d4
        move.l  first_q(sp),d3

        move.l  d3,d0
        or.l    d6,d0                   ; its top bit is the larger one's
        bfffo   d0{0:32},d1
        subq.w  #1,d1
        lsl.l   d1,d3
        lsl.l   d1,d6
        move.l  a3,d7
        divu.l  d7,d3
        bne.s   .share
        moveq   #1,d3                   ; with 0, parts would be 1: out of their format
.share  divu.l  d7,d6
        and.w   #$fffe,d6               ; even
        move.l  d6,d0
        lsr.l   #1,d0
        move.l  d0,perspective_line_half(a1)
        move.l  d3,d0
        mulu.l  d7,d0
        move.l  d0,perspective_line_weight(a1)
        sub.l   d3,d6                   ; a pixel
        move.l  d6,perspective_line_dweight(a1)
        move.w  perspective_plan_bend(a6),d0
        or.w    perspective_plan_bend+2(a6),d0
        bne.s   .curves

.next   lea     scanline_sizeof(a0),a0
        lea     perspective_line_sizeof(a1),a1
        subq.l  #1,lines_left(sp)
        bne     .line
        lea     lines_left+4(sp),sp
        return_all

        ; d3 the first end's share, d4 dv, a5 du, d6 dweight, d7 n
.curves move.l  a5,d5
        minus   <neg.l d5>
        tst.l   d4
        minus   <neg.l d4>
        cmp.l   d4,d5
        bhs.s   .way
        move.l  d4,d5
.way    tst.l   d5
        beq     .straight
        move.l  d6,d4
        beq     .straight
        minus   <neg.l d4>
        move.l  perspective_plan_bend(a6),d2
        logarithm d5,log_up
        logarithm d4,log_up
        logarithm d4,log_up
        move.l  perspective_line_weight(a1),d5
        bne.s   .first
        moveq   #1,d5
.first  logarithm d5,log_up
        add.l   d3,d6
        mulu.l  d7,d6                   ; the last pixel's weight
        bne.s   .last
        moveq   #1,d6
.last   logarithm d6,log_up
        neg.w   d2
        logarithm d7,log_down
        neg.w   d2
        addq.w  #3,d2
        asr.w   #2,d2
        lea     perspective_line_enough4(a1),a2
        lea     power_up(pc),a3
        moveq   #4-1,d4
.length add.w   #48,d2                  ; 3 octaves of error are 3/4 of one of weight
        moveq   #0,d0
        move.w  d2,d1
        bmi.s   .enough
        cmp.w   #31*64,d1
        bhs.s   .never
        moveq   #63,d3
        and.w   d1,d3
        lsr.w   #6,d1
        eor.w   #31,d1
        move.w  (a3,d3.w*2),d0
        swap    d0
        lsr.l   d1,d0
        addq.l  #1,d0
        bra.s   .enough
.never  moveq   #-1,d0
        lsr.l   #1,d0
.enough move.l  d0,(a2)+
        dbra    d4,.length
        bra     .next
.straight
        clr.l   perspective_line_enough4(a1)
        clr.l   perspective_line_enough8(a1)
        clr.l   perspective_line_enough16(a1)
        clr.l   perspective_line_enough32(a1)
        bra     .next

        walk_turns

; 64 log2(1 + (i + 1) / 64), rounded up
log_up
        dc.b    2,3,5,6,7,9,10,11,13,14,15,16,18,19,20,21
        dc.b    22,23,25,26,27,28,29,30,31,32,33,34,35,36,37,38
        dc.b    39,40,41,42,43,44,44,45,46,47,48,49,50,51,51,52
        dc.b    53,54,55,55,56,57,58,59,59,60,61,62,62,63,64,64

; 64 log2(1 + i / 64), rounded down
log_down
        dc.b    0,1,2,4,5,6,8,9,10,12,13,14,15,17,18,19
        dc.b    20,21,22,24,25,26,27,28,29,30,31,32,33,34,35,36
        dc.b    37,38,39,40,41,42,43,43,44,45,46,47,48,49,50,50
        dc.b    51,52,53,54,54,55,56,57,58,58,59,60,61,61,62,63

; 2^(15 + i / 64), rounded up
power_up
        dc.w    32768,33125,33486,33851,34219,34592,34969,35349
        dc.w    35734,36123,36517,36914,37316,37723,38133,38549
        dc.w    38968,39393,39822,40255,40694,41137,41585,42038
        dc.w    42495,42958,43426,43899,44377,44860,45348,45842
        dc.w    46341,46846,47356,47872,48393,48920,49453,49991
        dc.w    50536,51086,51642,52205,52773,53348,53929,54516
        dc.w    55109,55710,56316,56929,57549,58176,58810,59450
        dc.w    60097,60752,61413,62082,62758,63441,64132,64831
