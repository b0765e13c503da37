        include "routine.i"
        include "layout.i"

;==============================================================================
; span_fill - draws a scanline table in one colour
;
; in:      a0  span_plan*  the table, the frame, the colour
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, left and count of its lines
; writes:  the pixels of the lines, nothing else
; formats: 8-bit chunky pixels
; error:   none
; cost:    bench row fill
;==============================================================================
; Bytes up to a longword boundary, longwords 16 at a time, bytes at the end.

        routine span_fill,a0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l span_plan_lines(a0),a1
        move.l  span_plan_count(a0),d7
        movea.l span_plan_row(a0),a6
        movea.l span_plan_pitch(a0),a5
        move.b  span_plan_colour+3(a0),d0
        move.b  d0,d1
        lsl.w   #8,d0
        move.b  d1,d0
        move.w  d0,d1
        swap    d0
        move.w  d1,d0                   ; four pixels
        lea     .longwords_end(pc),a3
        moveq   #scanline_sizeof-4,d6
        subq.l  #1,d7

.line   moveq   #0,d1
        move.w  (a1)+,d1                ; left
        move.w  (a1)+,d2                ; count
        ble.s   .next
        lea     (a6,d1.l),a0
        move.w  a0,d3
        neg.w   d3
        and.w   #3,d3                   ; bytes up to a longword boundary
        cmp.w   d2,d3
        blo.s   .head
        move.w  d2,d3                   ; a short span may end before it
.head   sub.w   d3,d2
        subq.w  #1,d3
        bmi.s   .aligned
.head_byte
        move.b  d0,(a0)+
        dbra    d3,.head_byte
.aligned
        move.w  d2,d3
        and.w   #3,d2                   ; bytes left at the end
        lsr.w   #2,d3                   ; longwords
        beq.s   .tail
        moveq   #15,d4
        and.w   d3,d4
        neg.w   d4                      ; 2 bytes of code a longword
        lsr.w   #4,d3
        jmp     (a3,d4.w*2)
.longwords
        rept    16
        move.l  d0,(a0)+
        endr
.longwords_end
        dbra    d3,.longwords
.tail   subq.w  #1,d2
        bmi.s   .next
.tail_byte
        move.b  d0,(a0)+
        dbra    d2,.tail_byte
.next   adda.l  d6,a1
        adda.l  a5,a6
        dbra    d7,.line
        movem.l (sp)+,d2-d7/a2-a6
        rts
