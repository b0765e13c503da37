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

; \1 = \1 / d3, 16.16, d3 one pixel or more: the quotient fits. Uses d7.
over_width macro
        swap    \1
        move.w  \1,d7
        ext.l   d7
        clr.w   \1
        divs.l  d3,d7:\1
        up      \1
        endm

; \1 = \1 and \2 times d6, 16.16. Uses d0/d7.
move_on macro
        move.l  \2,d0
        muls.l  d6,d7:d0
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

        ; d0 x  d1 u  d2 v of the left side  d3 x  d4 u  d5 v of the right one, less those  d6 the first pixel
.line   move.w  scanline_left(a4),d6
        cmp.w   scanline_last(a4),d6
        bgt     .empty
        movem.l ramp_x(a1),d0-d2/d4-d6
        add.l   d0,d4
        add.l   d1,d5
        add.l   d2,d6
        movem.l d4-d6,ramp_x(a1)        ; on the next line
        movem.l ramp_x(a2),d3-d7/a0
        add.l   d3,d6
        add.l   d4,d7
        adda.l  d5,a0
        movem.l d6-d7/a0,ramp_x(a2)
        moveq   #0,d6
        move.w  scanline_left(a4),d6
        sub.w   #EDGE_BIAS,d6           ; its column
        sub.l   d1,d4                   ; u1 - u0
        sub.l   d2,d5
        tst.l   ramp_plan_truncated(a6)
        bne     .truncated
        swap    d6
        sub.l   d0,d6                   ; from the crossing to the pixel's centre
        sub.l   d0,d3                   ; x1 - x0
        cmp.l   #$10000,d3
        blt     .narrow
.wide   over_width d4
        over_width d5
        move_on d1,d4
        move_on d2,d5

.start  move.l  d4,(a3)+
        move.l  d5,(a3)+
        tst.l   ramp_plan_packed(a6)
        beq     .plain
        pack_start d1,d2,d3,a4

.next   lea     scanline_sizeof(a4),a4
        cmpa.l  a5,a4
        bne     .line
        turn    a1
        turn    a2
        tst.l   (sp)
        bne     .edges
        addq.l  #4,sp
        return_all

.empty  addq.l  #scanline_step_sizeof,a3
        down    a1
        down    a2
        bra     .next

.plain  move.w  d1,scanline_start0(a4)
        swap    d1
        move.w  d1,scanline_start1(a4)
        move.l  d2,scanline_start2(a4)
        bra     .next

.narrow cmp.l   #-$40000000,d3          ; an overflow: sides at both ends of the range
        blt.s   .widest                 ; have drifted further apart
        tst.l   d6
        bpl.s   .right_of_left
        moveq   #0,d6
.right_of_left
        cmp.l   d3,d6
        ble.s   .left_of_right
        move.l  d3,d6
.left_of_right
        tst.l   d3
        ble.s   .no_width
        muls.l  d6,d7:d4
        divs.l  d3,d7:d4
        add.l   d4,d1
        muls.l  d6,d7:d5
        divs.l  d3,d7:d5
        add.l   d5,d2
.no_width
        moveq   #0,d4
        moveq   #0,d5
        bra     .start

.widest move.l  #$7fffffff,d3
        bra     .wide

.truncated
        move.l  #$ffff,d7
        add.l   d7,d0
        swap    d0
        ext.l   d0                      ; ceil of the left side
        add.l   d7,d3
        swap    d3
        ext.l   d3
        sub.l   d0,d3                   ; pixels of the whole line, up to 32,769
        ble.s   .no_pixels
        divsl.l d3,d7:d4
        up      d4
        divsl.l d3,d7:d5
        up      d5
        bra.s   .cut
.no_pixels
        moveq   #0,d4
        moveq   #0,d5
.cut    sub.w   d0,d6
        ext.l   d6                      ; pixels cut off at the left
        move.l  d4,d0
        muls.l  d6,d0
        add.l   d0,d1
        move.l  d5,d0
        muls.l  d6,d0
        add.l   d0,d2
        bra     .start
