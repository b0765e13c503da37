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

; Rounds the quotient \1 up; d7 is its remainder.
up      macro
        tst.l   d7
        ble.s   .up\@
        addq.l  #1,\1
.up\@
        endm

; \1 = \1 / d0, 16.16, d0 one pixel or more: the quotient fits. Uses d7.
over_width macro
        swap    \1
        move.w  \1,d7
        ext.l   d7
        clr.w   \1
        divs.l  d0,d7:\1
        up      \1
        endm

; \1 = \1 and \2 times d3, 16.16. Uses d0/d7.
move_on macro
        move.l  \2,d0
        muls.l  d3,d7:d0
        move.w  d7,d0
        swap    d0
        add.l   d0,\1
        endm

; Steps the ramp \1 to the next line. Uses d0-d2.
down    macro
        movem.l ramp_dx(\1),d0-d2
        add.l   d0,ramp_x(\1)
        add.l   d1,ramp_u(\1)
        add.l   d2,ramp_v(\1)
        endm

; \1 = the side's next ramp after its last line.
turn    macro
        tst.l   ramp_lines(\1)
        bne.s   .same\@
        lea     ramp_sizeof(\1),\1
.same\@
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
        move.l  ramp_plan_count(a6),-(sp)       ; lines that are left

.edges  move.l  (sp),d0                 ; lines up to the next vertex
        cmp.l   ramp_lines(a1),d0
        ble.s   .left
        move.l  ramp_lines(a1),d0
.left   cmp.l   ramp_lines(a2),d0
        ble.s   .right
        move.l  ramp_lines(a2),d0
.right  sub.l   d0,ramp_lines(a1)
        sub.l   d0,ramp_lines(a2)
        sub.l   d0,(sp)
        mulu.w  #scanline_sizeof,d0
        lea     (a4,d0.l),a5

.line   moveq   #0,d3
        move.w  scanline_left(a4),d3
        cmp.w   scanline_last(a4),d3
        bgt     .next
        sub.w   #EDGE_BIAS,d3           ; column of the first pixel
        movem.l ramp_x(a1),d4-d6
        movem.l ramp_x(a2),d0-d2
        sub.l   d5,d1                   ; u1 - u0
        sub.l   d6,d2
        tst.l   ramp_plan_truncated(a6)
        bne     .truncated
        swap    d3
        sub.l   d4,d3                   ; from the crossing to the pixel's centre
        sub.l   d4,d0                   ; x1 - x0
        cmp.l   #$10000,d0
        blt     .narrow
.wide   over_width d1
        over_width d2
        move_on d5,d1
        move_on d6,d2

.start  move.l  d1,(a3)
        move.l  d2,4(a3)
        tst.l   ramp_plan_packed(a6)
        beq     .plain
        pack_start d5,d6,d4,a4

.next   addq.l  #scanline_step_sizeof,a3
        lea     scanline_sizeof(a4),a4
        down    a1
        down    a2
        cmpa.l  a5,a4
        bne     .line
        turn    a1
        turn    a2
        tst.l   (sp)
        bne     .edges
        addq.l  #4,sp
        return_all

.plain  move.w  d5,scanline_start0(a4)
        swap    d5
        move.w  d5,scanline_start1(a4)
        move.l  d6,scanline_start2(a4)
        bra     .next

.narrow cmp.l   #-$40000000,d0          ; an overflow: sides at both ends of the range
        blt.s   .widest                 ; have drifted further apart
        tst.l   d3
        bpl.s   .right_of_left
        moveq   #0,d3
.right_of_left
        cmp.l   d0,d3
        ble.s   .left_of_right
        move.l  d0,d3
.left_of_right
        tst.l   d0
        ble.s   .no_width
        muls.l  d3,d7:d1
        divs.l  d0,d7:d1
        add.l   d1,d5
        muls.l  d3,d7:d2
        divs.l  d0,d7:d2
        add.l   d2,d6
.no_width
        moveq   #0,d1
        moveq   #0,d2
        bra     .start

.widest move.l  #$7fffffff,d0
        bra     .wide

.truncated
        move.l  #$ffff,d7
        add.l   d7,d4
        swap    d4
        ext.l   d4                      ; ceil of the left side
        add.l   d7,d0
        swap    d0
        ext.l   d0
        sub.l   d4,d0                   ; pixels of the whole line, up to 32,769
        ble.s   .no_pixels
        divsl.l d0,d7:d1
        up      d1
        divsl.l d0,d7:d2
        up      d2
        bra.s   .cut
.no_pixels
        moveq   #0,d1
        moveq   #0,d2
.cut    sub.w   d4,d3
        ext.l   d3                      ; pixels cut off at the left
        move.l  d1,d0
        muls.l  d3,d0
        add.l   d0,d5
        move.l  d2,d0
        muls.l  d3,d0
        add.l   d0,d6
        bra     .start
