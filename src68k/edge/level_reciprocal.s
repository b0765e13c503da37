        include "level_reciprocal.i"

; level_reciprocal - starts and steps of lines of one depth each, by one reciprocal a line
;
; in:      a0  perspective_plan*  the table, the planes, width, spare and chained; there is no tilt
;          a1  scanline_step*     for the steps of u and v, one entry a line
; out:     d0  int32              1; 0 if the numbers do not fit: nothing is written
; reads:   the plan, left and last of its lines
; writes:  start0, start1, start2 of the plan's lines, addx form, and their steps; not
;          those of empty lines
; formats: u = K + C R / 2^32 and du = dC R / 2^32, rounded down, plus 1, or 2 if the plan is chained and v goes down;
;          16.16. dv is 0 if t does not change along lines. K = ds/dy / dq/dy is for all lines, C = s - K q for all lines
;          at one x, R = (2^32 2^shift - 1) / q.hi, q that of the width's middle, stepped with 16 bits of fraction and up
;          to 2^-6 above its plane. C of both ends, shifted right, is below 2^31
; error:   u is between 0 and 8 units, 2 A / q.hi, and as many times R / 2^32 + 1, or 2 in a chain, as the pixel is right
;          of the plan's left, above s / q; A is |K| and the plan's upper limit. Nothing is clamped
; cost:    350 cycles a line, 1,000 before the first one

        routine level_reciprocal,a0,a1
        save_all
        movea.l a0,a6
        lea     -inverse_sizeof(sp),sp
        movea.l sp,a4
        movea.l a1,a3
        pea     inverse_lines(pc)
        xdef    inverse_begin,_inverse_begin
; Finds what the lines of a plan have in common. In: a6 the plan, a4 room for inverse_sizeof bytes. Out: d0 1, or 0 if
; the numbers do not fit; there, K, C's step to a line whose x is the last one's, inverse_up, q and its growth; a0 the
; table, d1 its end, a5 x from which C is counted, a2 2^shift - 1, d2 C of u, d3 C of v, d7 dC of u. Keeps a3.
_inverse_begin
inverse_begin
        ; q's growth: d6 = 32 bits of it, shifted left by d5; and q of the line that is farthest
        movem.l perspective_plan_q+screen_plane_dy(a6),d0-d1
        move.l  d0,inverse_sign(a4)
        moveq   #0,d7
        tst.l   d0
        bpl.s   .grows
        move.l  perspective_plan_count(a6),d7
        subq.l  #1,d7
        neg.l   d1
        negx.l  d0
.grows  move.l  d0,d6
        beq     .not
        bfffo   d6{0:32},d5
        lsl.l   d5,d6
        moveq   #32,d4
        sub.l   d5,d4
        lsr.l   d4,d1
        or.l    d1,d6
        lea     perspective_plan_q(a6),a5
        movem.l screen_plane_at(a5),d0-d3   ; dx behind it
        or.l    d2,d3
        beq.s   .level
        move.l  perspective_plan_width(a6),d4
        lsr.l   #1,d4
        line_up screen_plane_dx,d4
.level  movem.l d0-d1,inverse_q(a4)
        line_up screen_plane_dy,d7
        move.l  d0,inverse_far(a4)
        ble     .not
        move.l  d1,inverse_far+number64_lo(a4)
        clr.l   inverse_most(a4)
        lea     perspective_plan_s(a6),a5
        lea     perspective_plan_u(a6),a0
        lea     inverse_u(a4),a1
        bsr     inverse_find
        bne     .not
        lea     perspective_plan_t(a6),a5
        lea     perspective_plan_v(a6),a0
        lea     inverse_v(a4),a1
        bsr     inverse_find
        bne     .not

        ; d5 = the shift that leaves 31 bits of C, and of what its rounded steps add; d4 = R of the farthest line
        move.l  inverse_most(a4),d0
        move.l  d0,d1
        moveq   #12,d2
        lsr.l   d2,d1
        add.l   d1,d0
        addq.l  #1,d0
        bfffo   d0{0:32},d0
        moveq   #33,d5
        sub.l   d0,d5
        moveq   #29,d0
        cmp.l   d0,d5
        bgt     .not
        moveq   #2,d0
        lsl.l   d5,d0
        cmp.l   inverse_far(a4),d0
        bhi     .not
        lsr.l   #1,d0
        subq.l  #1,d0
        movea.l d0,a2
        moveq   #-1,d4
        divu.l  inverse_far(a4),d0:d4
        moveq   #32,d6
        sub.l   d5,d6
        shifted inverse_v+inverse_c(a4),d3
        shifted inverse_u+inverse_c(a4),d2
        shifted perspective_plan_t+screen_plane_dx(a6),d7
        move.l  d7,inverse_v+inverse_dc(a4)
        smi     d0
        and.l   perspective_plan_chained(a6),d0
        addq.l  #1,d0
        move.l  d0,inverse_up(a4)
        move.l  perspective_plan_t+screen_plane_dx(a6),d0
        or.l    perspective_plan_t+screen_plane_dx+number64_lo(a6),d0
        sne     d0
        neg.b   d0
        extb.l  d0
        move.l  d0,inverse_up_v(a4)
        muls.l  d4,d0:d7
        add.l   #INVERSE_FAST,d0
        cmp.l   #2*INVERSE_FAST,d0
        bhs     .not
        swap    d4
        mulu.w  perspective_plan_width+2(a6),d4
        clr.w   d4
        swap    d4
        addq.l  #1,d4
        cmp.l   perspective_plan_spare(a6),d4
        bgt     .not
        shifted perspective_plan_s+screen_plane_dx(a6),d7

        move.l  d7,inverse_u+inverse_dc(a4)
        moveq   #0,d6
        move.l  d6,inverse_whole(a4)
        move.l  d6,inverse_u+inverse_step(a4)
        move.l  d6,inverse_v+inverse_step(a4)
        move.l  d7,inverse_u+inverse_more(a4)
        move.l  inverse_v+inverse_dc(a4),inverse_v+inverse_more(a4)
        move.l  perspective_plan_q+screen_plane_dy(a6),inverse_dq(a4)
        move.l  perspective_plan_q+screen_plane_dy+number64_lo(a6),d0
        clr.w   d0
        move.l  d0,inverse_dq+number64_lo(a4)
        move.l  perspective_plan_count(a6),d0
        addq.l  #1,d0
        swap    d0
        add.l   inverse_q+number64_lo(a4),d0
        clr.w   d0
        move.l  d0,inverse_q+number64_lo(a4)
        move.l  inverse_q(a4),d0
        addx.l  d6,d0
        move.l  d0,inverse_q(a4)
        movea.l perspective_plan_lines(a6),a0
        movea.l perspective_plan_left(a6),a5
        lea     EDGE_BIAS(a5),a5
        move.l  perspective_plan_count(a6),d1
        mulu.w  #scanline_sizeof,d1
        add.l   a0,d1
        moveq   #1,d0
        rts
.not    moveq   #0,d0
        rts

inverse_lines
        tst.l   d0
        beq     .done

        ; a0 line  a1 steps  a2 2^shift - 1  a3 the table's end  a4 x  a5 x if the side goes on  a6 dC of u
        ; d0:d1 q  d2 C of u  d3 C of v  d4 R
        movea.l a3,a1
        movea.l d1,a3
        movem.l inverse_q(sp),d0-d1
        movea.l d7,a6
        bra.s   .line

.more   subq.l  #1,d6
        bne     .turn
        add.l   inverse_u+inverse_more(sp),d2
        add.l   inverse_v+inverse_more(sp),d3
        bra.s   .begin

.line   movea.w scanline_left(a0),a4
        move.l  a4,d6
        sub.l   a5,d6
        bne.s   .more
        add.l   inverse_u+inverse_step(sp),d2
        add.l   inverse_v+inverse_step(sp),d3
.begin  movea.l a4,a5
        adda.l  inverse_whole(sp),a5
        cmpa.w  scanline_last(a0),a4
        bgt     .empty
        move.l  a2,d5
        moveq   #-1,d4
        divu.l  d0,d5:d4
        move.l  a6,d7
        muls.l  d4,d6:d7
        add.l   inverse_up(sp),d6
        move.l  d6,(a1)+
        move.l  inverse_v+inverse_dc(sp),d7
        muls.l  d4,d6:d7
        add.l   inverse_up_v(sp),d6
        move.l  d6,(a1)+
        move.l  d2,d7
        muls.l  d4,d6:d7
        add.l   inverse_u+inverse_k(sp),d6
        move.l  d3,d7
        muls.l  d4,d5:d7
        add.l   inverse_v+inverse_k(sp),d5
        pack_start d6,d5,d7,a0
.next   add.l   inverse_dq+number64_lo(sp),d1
        move.l  inverse_dq(sp),d6
        addx.l  d6,d0
        lea     scanline_sizeof(a0),a0
        cmpa.l  a3,a0
        bne.s   .line
        moveq   #1,d0
.done   lea     inverse_sizeof(sp),sp
        return_all

.turn   addq.l  #1,d6                   ; at a vertex
        add.l   inverse_whole(sp),d6
        move.l  d6,inverse_whole(sp)
        turned  u,a6,d2
        turned  v,inverse_v+inverse_dc(sp),d3
        bra     .begin

.empty  addq.l  #scanline_step_sizeof,a1
        bra.s   .next

; Finds K and C of u or v. In: a0 the plan's base and limits, a5 the plane of s or t, a1 the frame's part, d5, d6: q's
; growth, d7: the farthest line. Out: Z if they fit. Uses d0-d4/a2.
inverse_find
        movem.l screen_plane_dy(a5),d2-d3
        move.l  inverse_sign(a4),d0
        eor.l   d2,d0
        movea.l d0,a2                   ; K's sign
        tst.l   d2
        minus   <neg.l d3>,<negx.l d2>
        moveq   #32,d4
        sub.l   d5,d4
        move.l  d2,d0
        lsr.l   d4,d0
        bne     .far
        lsl.l   d5,d2
        move.l  d3,d0
        lsr.l   d4,d0
        or.l    d0,d2
        lsl.l   d5,d3
        cmp.l   d6,d2
        bhs     .far
        divu.l  d6,d2:d3
        bmi     .far
        move.l  INVERSE_HIGH(a0),d0
        move.l  d0,d4
        add.l   d0,d0
        or.l    inverse_far(a4),d0
        cmp.l   d0,d3
        bhi     .far
        add.l   d3,d4                   ; A
        move.l  a2,d0
        minus   <neg.l d3>
        move.l  (a0),d0
        add.l   d3,d0
        addq.l  #INVERSE_RAISE,d0
        move.l  d0,inverse_k(a1)

        ; C = s - K q + A of the farthest line
        move.l  d3,d1
        muls.l  inverse_far(a4),d0:d1
        move.l  inverse_far+number64_lo(a4),d2
        tst.l   d3
        bpl.s   .rises
        sub.l   d2,d1
        bcc.s   .rises
        subq.l  #1,d0
.rises  mulu.l  d3,d3:d2
        add.l   d3,d1
        moveq   #0,d2
        addx.l  d2,d0
        sub.l   d4,d1
        subx.l  d2,d0
        movem.l d0-d1,inverse_c(a1)
        movem.l screen_plane_at(a5),d0-d1
        line_up screen_plane_dy,d7
        sub.l   inverse_c+number64_lo(a1),d1
        move.l  inverse_c(a1),d2
        subx.l  d2,d0
        movem.l d0-d1,inverse_c(a1)
        fitting
        move.l  screen_plane_dx(a5),d0
        add.l   #INVERSE_STEEP,d0
        cmp.l   #2*INVERSE_STEEP,d0
        bhs.s   .far
        movem.l inverse_c(a1),d0-d1
        move.l  perspective_plan_width(a6),d4
        line_up screen_plane_dx,d4
        fitting
        moveq   #0,d0
        rts
.far    moveq   #1,d0
        rts
