; Spans along columns of the frame: their lines' pixels are below one another, a3 bytes from one to the next.

        include "span.i"

; Draws the texel at d4 and goes on to the pixel below. 6 bytes.
draw_upright macro
        movea.l d4,a2
        move.b  (a2),(a1)
        adda.l  a3,a1
        endm

; Takes the plan in a0.
upright_open macro
        span_open
        movea.l (sp),a3
        move.l  span_plan_steps(a0),(sp)
        move.l  span_plan_map(a0),d4    ; mm00
        span_table
        endm

; As span_line, and a2 = the line's steps.
upright_line macro
.line   move.l  (a0)+,d0                ; start0:left
        moveq   #0,d6
        move.w  d0,d6
        move.l  (a0)+,d7                ; last:start1
        move.w  d7,d0
        swap    d7
        sub.w   d6,d7
        bmi     .empty
        move.l  a3,d1
        muls.l  d1,d6
        lea     (a6,d6.l),a1
        move.l  (a0)+,d1
        movea.l (sp),a2
        endm

; Ends the pixels and the table's loop.
upright_close macro
        dbra    d7,.pixels
.line_next
        addq.l  #8,(sp)
        addq.l  #1,a6
        cmpa.l  a5,a0
        bne     .line
        addq.l  #4,sp
        rts
.empty  addq.l  #4,a0
        bra     .line_next
        endm
