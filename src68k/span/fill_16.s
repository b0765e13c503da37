        include "span.i"

; span_fill_16 - draws a scanline table in one colour of two bytes
;
; like:    span_fill
; formats: 16-bit pixels at even addresses; the colour in the plan's lower word

; One pixel up to a longword boundary, longwords 32 at a time, one pixel at the end.

        span span_fill_16
        fill_open
        move.w  span_plan_colour+2(a0),d0
        move.w  d0,d1
        swap    d0
        move.w  d1,d0                   ; two pixels
        lea     .longwords_end(pc),a3
        moveq   #scanline_sizeof-6,d6
        moveq   #31,d5
        subq.l  #1,d7
.line   move.l  (a1)+,d2                ; --:left
        lea     (a6,d2.w*2),a0
        move.w  d2,d3
        move.w  (a1)+,d2
        sub.w   d3,d2
        bmi.s   .next
        addq.w  #1,d2
        move.w  a0,d3
        btst    #1,d3
        beq.s   .aligned
        move.w  d0,(a0)+
        subq.w  #1,d2
.aligned
        move.w  d2,d3
        lsr.w   #1,d3                   ; longwords
        fill_longwords
        btst    #0,d2
        beq.s   .next
        move.w  d0,(a0)+
.next   adda.l  d6,a1
        adda.l  a5,a6
        dbra    d7,.line
        rts
