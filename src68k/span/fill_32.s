        include "span.i"

; span_fill_32 - draws a scanline table in one colour of four bytes
;
; like:    span_fill
; formats: 32-bit pixels at multiples of 4

        span span_fill_32
        fill_open
        move.l  span_plan_colour(a0),d0
        lea     .longwords_end(pc),a3
        moveq   #scanline_sizeof-6,d6
        moveq   #31,d5
        subq.l  #1,d7
.line   move.l  (a1)+,d2                ; --:left
        lea     (a6,d2.w*4),a0
        move.w  (a1)+,d3
        sub.w   d2,d3
        bmi.s   .next
        addq.w  #1,d3
        fill_longwords
.next   adda.l  d6,a1
        adda.l  a5,a6
        dbra    d7,.line
        rts
