        include "routine.i"
        include "layout.i"

; The start \1 within [\4, \5] less the way \2 that the line goes, both ends included.
; \3 is free.
hold    macro
        move.l  \4,\3
        tst.l   \2
        bpl.s   .rises\@
        sub.l   \2,\3                   ; lowest start
        cmp.l   \3,\1
        bge.s   .above\@
        move.l  \3,\1
.above\@
        cmp.l   \5,\1
        ble.s   .held\@
        move.l  \5,\1
        bra.s   .held\@
.rises\@
        cmp.l   \3,\1
        bge.s   .first\@
        move.l  \3,\1
.first\@
        move.l  \5,\3
        sub.l   \2,\3                   ; highest start
        cmp.l   \3,\1
        ble.s   .held\@
        move.l  \3,\1
.held\@
        endm

; Keeps the step \1 (memory) times d7 within the room from \2 to \3 (memory). Uses d0-d2.
limit   macro
        move.l  \3,d0
        sub.l   \2,d0
        divu.l  d7,d0                   ; the largest step
        move.l  \1,d1
        move.l  d1,d2
        bpl.s   .positive\@
        neg.l   d2
.positive\@
        cmp.l   d0,d2
        bls.s   .small\@
        tst.l   d1
        bpl.s   .write\@
        neg.l   d0
.write\@
        move.l  d0,\1
.small\@
        endm

;==============================================================================
; edge_hold - moves the lines of a table so that no pixel leaves a range of u and v
;
; in:      a0  hold_plan*  the table, the steps, the ranges
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines
; writes:  start0, start1, start2 of the lines (plain form); dudx, dvdx where even the
;          longest line could not stay in the range with them
; formats: u, v, ranges 16.16; both ends of a range belong to it
; error:   none: a line that was inside stays as it is; of others the start moves as
;          little as it can. With both ends inside, so is every pixel between
; cost:    about 130 cycles a line
;==============================================================================
        routine edge_hold,a0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l a0,a6

        ; the longest line
        movea.l hold_plan_lines(a6),a4
        move.l  hold_plan_count(a6),d6
        moveq   #0,d7
.longer move.w  scanline_last(a4),d0
        sub.w   scanline_left(a4),d0
        cmp.w   d0,d7
        bge.s   .shorter
        move.w  d0,d7
.shorter
        lea     scanline_sizeof(a4),a4
        subq.l  #1,d6
        bne.s   .longer
        tst.l   d7                      ; its pixels less one
        beq.s   .limited
        limit   hold_plan_dudx(a6),hold_plan_u_low(a6),hold_plan_u_high(a6)
        limit   hold_plan_dvdx(a6),hold_plan_v_low(a6),hold_plan_v_high(a6)
.limited
        movea.l hold_plan_lines(a6),a4
        move.l  hold_plan_count(a6),d7
        movem.l hold_plan_u_low(a6),d4-d5
        movea.l hold_plan_v_low(a6),a2
        movea.l hold_plan_v_high(a6),a3
        movea.l hold_plan_dudx(a6),a0
        movea.l hold_plan_dvdx(a6),a1
.line   move.w  scanline_last(a4),d6
        sub.w   scanline_left(a4),d6
        blt.s   .next
        ext.l   d6
        move.w  scanline_start1(a4),d0
        swap    d0
        move.w  scanline_start0(a4),d0
        move.l  a0,d1
        muls.l  d6,d1
        hold    d0,d1,d2,d4,d5
        move.w  d0,scanline_start0(a4)
        swap    d0
        move.w  d0,scanline_start1(a4)
        move.l  scanline_start2(a4),d0
        move.l  a1,d1
        muls.l  d6,d1
        hold    d0,d1,d2,a2,a3
        move.l  d0,scanline_start2(a4)
.next   lea     scanline_sizeof(a4),a4
        subq.l  #1,d7
        bne     .line
        movem.l (sp)+,d2-d7/a2-a6
        rts
