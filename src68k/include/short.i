; The frame of the spans for short lines: as many unrolled pixels as a line may have,
; entered in their middle, and no loop around them. The code that reads a line follows
; the pixels, so each line runs into the next; both must fit the instruction cache.

        include "chain.i"

; Takes the plan in a0; after it a3 is the pitch, a6 the row and d7 the number of
; lines. If \1 is given, the map is in d4 (mm00), dudx in \1 and dvdx in \2. \3: another field
; of the plan to push. The code that follows must set a0 to the lines and go to .line.
short_open macro
        movea.l span_plan_pitch(a0),a3
        movea.l span_plan_row(a0),a6
        move.l  span_plan_count(a0),d7
        ifnb    \1
        move.l  span_plan_map(a0),d4
        ifnb    \3
        move.l  span_plan_\3(a0),-(sp)
        endc
        move.l  span_plan_dudx(a0),\1
        ifnb    \2
        move.l  span_plan_dvdx(a0),\2
        endc
        endc
        endm

; Ends the pixels and reads a line: a1 = first pixel, d0 = start0:start1, d6 =
; -(pixels - 1), a0 at start2. Only d7's lower word counts lines.
short_line macro
        short_next
        move.w  (a0)+,d6
        sub.w   d0,d6
        bmi.s   .empty
        neg.w   d6
        move.w  (a0)+,d0
        endm

; The same for lines without start0: start1 goes to \1's lower word. It is faster in
; chip RAM by one memory access.
short_line_alone macro
        short_next
        move.l  (a0)+,d6                ; last:start1
        move.w  d6,\1
        swap    d6
        sub.w   d0,d6
        bmi.s   .empty_alone
        neg.w   d6
        endm

short_next macro
.pixels_end
.next   adda.l  a3,a6
.line   subq.w  #1,d7
        bmi.s   .done
        move.l  (a0)+,d0                ; start0:left
        lea     (a6,d0.w),a1
        endm

; Ends the span, after the jump to the pixels. \1: bytes on the stack, if any.
short_close macro
.empty  addq.l  #2,a0
.empty_alone
        addq.l  #4,a0
        bra     .next
.done
        ifnb    \1
        addq.l  #\1,sp
        endc
        rts
        endm
