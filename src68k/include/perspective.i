; Planes of q, s and t stepped from line to line (see c/span/perspective.h).

        include "number.i"

; The planes at the line's first possible pixel, on the stack in this order.
row_q   equ     0
row_s   equ     8
row_t   equ     16
row_lines equ   24                      ; lines left
row_sizeof equ  28

; d0:d1 = the row's plane \1, d7 pixels to the right (0 to 65,535). Uses d2.
value   macro
        move.l  perspective_plan_\1+screen_plane_dx+number64_lo(a6),d1
        mulu.l  d7,d0:d1
        move.l  perspective_plan_\1+screen_plane_dx+number64_hi(a6),d2
        muls.l  d7,d2
        add.l   d2,d0
        add.l   row_\1+number64_lo(sp),d1
        move.l  row_\1(sp),d2
        addx.l  d2,d0
        endm

; d1 = d0:d1 / \2, cut towards zero and clamped to the range of \1, u or v. Uses d0/d2. A
; comparison finds quotients that do not fit 32 bits, except for the last bit, which V
; shows: FS-UAE gives 0 without V from 2^32 on.
quotient macro
        move.l  d0,d2
        minus   <not.l d2>
        add.l   d2,d2
        cmp.l   \2,d2
        bhs.s   .far\@
        divs.l  \2,d0:d1
        bvs.s   .far\@
        cmp.l   perspective_plan_\1_low(a6),d1
        blt.s   .low\@
        cmp.l   perspective_plan_\1_high(a6),d1
        ble.s   .inside\@
.high\@ move.l  perspective_plan_\1_high(a6),d1
        bra.s   .inside\@
.far\@  tst.l   d0
        bpl.s   .high\@
.low\@  move.l  perspective_plan_\1_low(a6),d1
.inside\@
        endm

; \1 = q's upper half d0, clamped to q_low at least.
weight  macro
        move.l  perspective_plan_q_low(a6),\1
        cmp.l   d0,\1
        bge.s   .held\@
        move.l  d0,\1
.held\@
        endm

; Steps the row's plane \1 to the next line. Uses d0-d1.
plane_next macro
        next    row_\1,perspective_plan_\1+screen_plane_dy,a6
        endm

; Moves the plan from a0 to a6 and pushes its first row.
rows_open macro
        movea.l a0,a6
        move.l  perspective_plan_count(a6),-(sp)
        movem.l perspective_plan_t+screen_plane_at(a6),d0-d1
        movem.l d0-d1,-(sp)
        movem.l perspective_plan_s+screen_plane_at(a6),d0-d1
        movem.l d0-d1,-(sp)
        movem.l perspective_plan_q+screen_plane_at(a6),d0-d1
        movem.l d0-d1,-(sp)
        endm

; Steps all planes to the next line.
rows_next macro
        plane_next q
        plane_next s
        plane_next t
        endm
