; The frame of every textured span routine: the loop over the scanline table
; around an unrolled loop over pixels that is entered in its middle. The loop must
; fit the instruction cache of 256 bytes.

        include "chain.i"

; Takes the plan in a0; after it (sp) is the pitch and a6 the row.
span_open macro
        move.l  span_plan_pitch(a0),-(sp)
        span_begin
        endm

; The same without the pitch.
span_begin macro
        movea.l span_plan_row(a0),a6
        movea.l span_plan_lines(a0),a5
        move.l  span_plan_count(a0),d0
        endm

; After span_open, once the plan is read: a0 = table, a5 = its end (d0 lines).
span_table macro
        movea.l a5,a0
        lsl.l   #2,d0
        adda.l  d0,a5
        lea     (a5,d0.l*2),a5
        endm

; Reads a table entry: a1 first pixel, d7 pixels - 1, \1 start0:start1, \2 start2 (it
; may be left out). Goes to .line_next if the line is empty. \3: *2 for pixels of two
; bytes. Uses a2.
span_line macro
        bra.s   .line
.empty  addq.l  #4,a0
        bra     .line_next
.line   move.l  (a0)+,\1                ; start0:left
        movea.w \1,a2
        lea     (a6,\1.w\3),a1
        move.l  (a0)+,d7                ; last:start1
        move.w  d7,\1
        swap    d7
        sub.w   a2,d7
        bmi.s   .empty
        ifb     \2
        addq.l  #4,a0
        else
        move.l  (a0)+,\2
        endc
        endm

; Prepares a loop of 2^\1 pixels a round: d7 = rounds - 1, d6 = -(pixels of the short
; first round - 1). span_enter jumps there, relative to a3 = .pixels_end less one pixel; its
; arguments and 8 add up to a pixel's bytes of code. Code that sets X goes between the two.
; Uses a2.
span_rounds macro
        moveq   #(1<<\1)-1,d6
        and.w   d7,d6
        neg.w   d6
        lsr.w   #\1,d7
        endm

span_enter macro
        lea     (a3,d6.w*\1),a2
        ifnb    \2
        lea     (a2,d6.w*\2),a2
        endc
        jmp     (a2,d6.w*8)
        endm

; The same where all address registers are taken: d6 = the pixels that the short first
; round leaves out of 2^\1; the jump is relative to .pixels, which must follow. An
; entry of 8 bytes is jmp .pixels(pc,d6.w*8).
span_rounds_out macro
        moveq   #(1<<\1)-1,d6
        or.w    d7,d6
        sub.w   d7,d6
        lsr.w   #\1,d7
        endm

span_enter_out macro
        lea     .pixels(pc,d6.w*\1),a2
        ifnb    \2
        lea     (a2,d6.w*\2),a2
        endc
        jmp     (a2,d6.w*8)
        endm

; Ends the pixels and the table's loop. \1: the pitch, (sp) or a register; \2: bytes
; on the stack, if there are more than the pitch.
span_close macro
.pixels_end
        dbra    d7,.pixels
        span_next \1,\2
        endm

; Ends only the table's loop.
span_next macro
.line_next
        adda.l  \1,a6
        cmpa.l  a5,a0
        bne     .line
        ifb     \2
        addq.l  #4,sp
        else
        ifne    \2
        addq.l  #\2,sp
        endc
        endc
        rts
        endm

; Opens a span whose lines have steps of their own: their address is pushed on the pitch. \1 = the map.
level_open macro
        span_open
        move.l  span_plan_steps(a0),-(sp)
        move.l  span_plan_map(a0),\1
        span_table
        endm

; The steps of a line for the chain. Uses d5/a2.
level_steps macro
        movea.l (sp),a2
        move.l  (a2)+,d2
        move.l  (a2),d5
        chain_steps
        endm

; Ends the pixels and the table's loop after level_open.
level_next macro
        dbra    d7,.pixels
.line_next
        addq.l  #8,(sp)
        adda.l  4(sp),a6
        cmpa.l  a5,a0
        bne     .line
        addq.l  #8,sp
        rts
        endm

; Opens a span of one colour: a1 = table, d7 = lines, a6 = row, a5 = pitch.
fill_open macro
        movea.l span_plan_lines(a0),a1
        move.l  span_plan_count(a0),d7
        movea.l span_plan_row(a0),a6
        movea.l span_plan_pitch(a0),a5
        endm

; Writes d3 longwords of d0 from (a0) on, 32 at a time. In: a3 = .longwords_end,
; d5 = 31. Uses d4.
fill_longwords macro
        move.w  d3,d4
        and.w   d5,d4
        neg.w   d4                      ; 2 bytes of code a longword
        lsr.w   #5,d3
        jmp     (a3,d4.w*2)
.longwords
        rept    32
        move.l  d0,(a0)+
        endr
.longwords_end
        dbra    d3,.longwords
        endm
