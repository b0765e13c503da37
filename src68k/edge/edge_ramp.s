        include "chain.i"

; edge_ramp - u, v and their steps on each scanline, by two divides a scanline
;
; in:      a0  ramp_plan*  the table, both sides' ramps, where the steps go
; reads:   the plan, left and last of its lines
; writes:  start0, start1, start2 of lines with pixels and their entry of steps; the
;          ramps, which are stepped down
; formats: x, u, v 16.16; starts plain, or packed as the addx form has them.
;          truncated: u where the left side crosses the line, steps (u1 - u0) / whole
;          pixels. Otherwise u at the first pixel, steps (u1 - u0) / (x1 - x0); on a
;          line under one pixel wide the steps are 0 and u is between u0 and u1.
; error:   steps are rounded up: less than 1/65536 a pixel; products are cut

; Rounds the quotient \1 up; d4 is its remainder.
up      macro
        tst.l   d4
        ble.s   .up\@
        addq.l  #1,\1
.up\@
        endm

; The table is already cut to the frame. A product moves the start from the left side to
; the first pixel, which includes the distance to the pixel's centre.

        routine edge_ramp,a0
        save_all
        movea.l a0,a6
        movea.l ramp_plan_lines(a6),a4
        movea.l ramp_plan_steps(a6),a3
        movea.l ramp_plan_left(a6),a1
        movea.l ramp_plan_right(a6),a2
        move.l  ramp_plan_count(a6),d7

.line   move.w  scanline_last(a4),d0
        cmp.w   scanline_left(a4),d0
        blt     .next
        move.l  ramp_u(a2),d0
        sub.l   ramp_u(a1),d0           ; u1 - u0
        move.l  ramp_v(a2),d1
        sub.l   ramp_v(a1),d1
        moveq   #0,d3
        move.w  scanline_left(a4),d3
        sub.w   #EDGE_BIAS,d3           ; column of the first pixel
        tst.l   ramp_plan_truncated(a6)
        bne     .truncated

        swap    d3
        sub.l   ramp_x(a1),d3           ; from the crossing to the pixel's centre
        move.l  ramp_x(a2),d2
        sub.l   ramp_x(a1),d2           ; x1 - x0
        cmp.l   #$10000,d2
        blt.s   .narrow
.wide   bsr     .over_width
        exg     d0,d1
        bsr     .over_width
        exg     d0,d1
        move.l  d0,d5
        muls.l  d3,d4:d5                ; the upper half of the lower word's sum
        move.w  d4,d5
        swap    d5
        move.l  d1,d6
        muls.l  d3,d4:d6
        move.w  d4,d6
        swap    d6
        bra.s   .start

.narrow cmp.l   #-$40000000,d2          ; an overflow: sides at both ends of the range
        blt     .widest                 ; have drifted further apart
        tst.l   d3
        bpl.s   .right_of_left
        moveq   #0,d3
.right_of_left
        cmp.l   d2,d3
        ble.s   .left_of_right
        move.l  d2,d3
.left_of_right
        moveq   #0,d5
        moveq   #0,d6
        tst.l   d2
        ble.s   .no_width
        muls.l  d3,d4:d0
        divs.l  d2,d4:d0
        move.l  d0,d5
        muls.l  d3,d4:d1
        divs.l  d2,d4:d1
        move.l  d1,d6
.no_width
        moveq   #0,d0
        moveq   #0,d1
        bra.s   .start

.truncated
        move.l  #$ffff,d5
        move.l  d5,d2
        add.l   ramp_x(a1),d5
        swap    d5                      ; ceil of the left side
        add.l   ramp_x(a2),d2
        swap    d2
        ext.l   d5
        ext.l   d2
        sub.l   d5,d2                   ; pixels of the whole line, up to 32,769
        ble.s   .no_pixels
        divsl.l d2,d4:d0
        up      d0
        divsl.l d2,d4:d1
        up      d1
        bra.s   .cut
.no_pixels
        moveq   #0,d0
        moveq   #0,d1
.cut    sub.w   d5,d3
        ext.l   d3                      ; pixels cut off at the left
        move.l  d0,d5
        muls.l  d3,d5
        move.l  d1,d6
        muls.l  d3,d6

.start  add.l   ramp_u(a1),d5
        add.l   ramp_v(a1),d6
        move.l  d0,(a3)
        move.l  d1,4(a3)
        tst.l   ramp_plan_packed(a6)
        bne.s   .packed
        move.w  d5,scanline_start0(a4)
        swap    d5
        move.w  d5,scanline_start1(a4)
        move.l  d6,scanline_start2(a4)
        bra.s   .next
.packed pack_start d5,d6,d4,a4

.next   addq.l  #8,a3
        lea     scanline_sizeof(a4),a4
        bsr.s   .down
        exg     a1,a2
        bsr.s   .down
        exg     a1,a2
        subq.l  #1,d7
        bne     .line
        return_all

.widest move.l  #$7fffffff,d2
        bra     .wide

; Steps the ramp in a1 to the next line; after its last line a1 moves to the side's next ramp.
.down   movem.l ramp_dx(a1),d0-d2
        add.l   d0,ramp_x(a1)
        add.l   d1,ramp_u(a1)
        add.l   d2,ramp_v(a1)
        subq.l  #1,ramp_lines(a1)
        bne.s   .same
        lea     ramp_sizeof(a1),a1
.same   rts

; d0 / d2, d2 one pixel or more: the quotient fits. Uses d4.
.over_width
        swap    d0
        move.w  d0,d4
        ext.l   d4
        clr.w   d0
        divs.l  d2,d4:d0
        up      d0
        rts
