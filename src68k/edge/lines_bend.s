        include "routine.i"

; lines_bend - whether a straight line would be too far off in one of a table
;
; in:      a0  perspective_plan*  the table, the planes, tilt and steep
;          d0  int32              pixels from the plan's left to the right end of the table's box
; out:     d0  int32              1 if a line is too far off, else 0
; reads:   the plan, left and last of its lines
; formats: a line of n + 1 pixels is too far off if steep n^2 / 2 is above the least q.hi of its row of the
;          box; steep n^2 is below 2^31 for every line of the box
; error:   q is stepped with its upper half, and too low by a unit a line
; cost:    about 170 cycles if a line as long as the box would not be, else 110 cycles a line and these

        routine lines_bend,a0,d0
        movem.l d2-d4/a2,-(sp)
        move.l  perspective_plan_q(a0),d3
        move.l  perspective_plan_steep(a0),d4
        move.l  d0,d1
        tst.l   perspective_plan_tilt(a0)
        bpl.s   .least
        muls.l  d4,d0
        sub.l   d0,d3
.least  movea.l perspective_plan_q+screen_plane_dy(a0),a2

        ; d2: the least q of the box
        move.l  perspective_plan_count(a0),d0
        move.l  a2,d2
        bpl.s   .first
        subq.l  #1,d0
        muls.l  d0,d2
        addq.l  #1,d0
        bra.s   .lowest
.first  moveq   #0,d2
.lowest add.l   d3,d2
        mulu.w  d1,d1
        mulu.l  d4,d1
        lsr.l   #1,d1
        cmp.l   d2,d1
        ble.s   .straight

        movea.l perspective_plan_lines(a0),a1
.line   move.w  scanline_last(a1),d2
        sub.w   scanline_left(a1),d2
        bmi.s   .next
        mulu.w  d2,d2
        mulu.l  d4,d2
        lsr.l   #1,d2
        cmp.l   d3,d2
        bgt.s   .bends
.next   add.l   a2,d3
        lea     scanline_sizeof(a1),a1
        subq.l  #1,d0
        bne.s   .line
.done   movem.l (sp)+,d2-d4/a2
        rts
.straight
        moveq   #0,d0
        bra.s   .done
.bends  moveq   #1,d0
        bra.s   .done
