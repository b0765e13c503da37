; The frame of every textured span routine: the loop over the scanline table
; around an unrolled loop over pixels that is entered in its middle. The loop has
; to fit the instruction cache of 256 bytes.

; Takes the plan in a0:  a0 table, a5 its end, a6 row, (sp) pitch.
span_open macro
        movem.l d2-d7/a2-a6,-(sp)
        move.l  span_plan_pitch(a0),-(sp)
        movea.l span_plan_row(a0),a6
        movea.l span_plan_lines(a0),a5
        move.l  span_plan_count(a0),d0
        endm

; After span_open and the reading of the plan: a0 = table, a5 = its end (d0 lines).
span_table macro
        movea.l a5,a0
        lsl.l   #2,d0
        adda.l  d0,a5
        lea     (a5,d0.l*2),a5
        endm

; Reads a table entry: a1 first pixel, d7 count, \1 and \2 packed start.
; Goes to .line_next where there is nothing to draw. Uses d6.
span_line macro
        bra.s   .line
.empty  addq.l  #8,a0
        bra     .line_next
.line   move.w  (a0)+,d6
        move.w  (a0)+,d7
        ble.s   .empty
        lea     (a6,d6.w),a1
        move.l  (a0)+,\1
        move.l  (a0)+,\2
        endm

; The rounds of 2^\1 pixels for d7 of them: d7 = rounds - 1, d6 = pixels that the
; first round leaves out. Then comes what must set X, then the span_enter for the
; pixel's bytes of code, which goes d6 pixels behind a3 = .pixels. Uses a2.
span_rounds macro
        move.w  d7,d6
        neg.w   d6
        and.w   #(1<<\1)-1,d6
        subq.w  #1,d7
        lsr.w   #\1,d7
        endm

span_enter_12 macro
        lea     (a3,d6.w*4),a2
        jmp     (a2,d6.w*8)
        endm

span_enter_14 macro
        lea     (a3,d6.w*2),a2
        lea     (a2,d6.w*4),a2
        jmp     (a2,d6.w*8)
        endm

span_enter_18 macro
        lea     (a3,d6.w*2),a2
        lea     (a2,d6.w*8),a2
        jmp     (a2,d6.w*8)
        endm

; The end of the pixels and of the table's loop.
span_close macro
        dbra    d7,.pixels
.line_next
        adda.l  (sp),a6
        cmpa.l  a5,a0
        bne     .line
        addq.l  #4,sp
        movem.l (sp)+,d2-d7/a2-a6
        rts
        endm
