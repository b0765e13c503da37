; The frame of the spans for short lines: as many unrolled pixels as a line may have,
; entered in their middle, and no loop. What reads a line stands behind them, so that
; one line runs into the next. Pixels and that have to fit the instruction cache.

; Registers that a span for short lines keeps.
SHORT_KEPT reg  d2-d7/a2-a4/a6

; Takes the plan in a0; after it a3 is the pitch, a6 the row, d4 the map (mm00) and d7
; the number of lines.
short_open macro
        movem.l SHORT_KEPT,-(sp)
        movea.l span_plan_pitch(a0),a3
        movea.l span_plan_row(a0),a6
        move.l  span_plan_map(a0),d4
        move.l  span_plan_count(a0),d7
        endm

; The end of the pixels and the beginning of a line: d0 start0:left, \1's lower word
; start1, a1 the first pixel, d6 = -(pixels - 1); a0 is at start2. short_open's plan
; leaves by movea.l span_plan_lines(a0),a0 and bra .line.
short_line macro
.pixels_end
.next   adda.l  a3,a6
.line   subq.w  #1,d7
        bmi.s   .done
        move.l  (a0)+,d0                ; start0:left
        lea     (a6,d0.w),a1
        ifc     \1,d0
        move.w  (a0)+,d6
        sub.w   d0,d6
        bmi.s   .empty
        neg.w   d6
        move.w  (a0)+,\1
        else
        move.l  (a0)+,d6
        move.w  d6,\1
        swap    d6
        sub.w   d0,d6
        bmi.s   .empty
        neg.w   d6
        endc
        endm

; Behind the jump to a line's pixels. \1: bytes on the stack, if there are any.
short_close macro
.empty  addq.l  #\1,a0
        bra     .next
.done
        ifnb    \2
        addq.l  #\2,sp
        endc
        movem.l (sp)+,SHORT_KEPT
        rts
        endm
