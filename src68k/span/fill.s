        include "span.i"

; span_fill - draws a scanline table in one colour
;
; in:      a0  span_plan*  the table, the frame, the colour
; trashes: d0-d7/a0-a6
; reads:   the plan, left and last of its lines
; writes:  the pixels of the lines, nothing else
; formats: 8-bit chunky pixels

; Short spans by bytes; long ones by a byte and a word up to a longword boundary,
; longwords 32 at a time, and a word and a byte at the end.

SHORT                   equ     12

        span span_fill
        fill_open
        move.b  span_plan_colour+3(a0),d0
        move.b  d0,d1
        lsl.w   #8,d0
        move.b  d1,d0
        move.w  d0,d1
        swap    d0
        move.w  d1,d0                   ; four pixels
        lea     .longwords_end(pc),a3
        lea     .bytes_end-2(pc),a4
        moveq   #scanline_sizeof-6,d6
        moveq   #31,d5
        subq.l  #1,d7
        bra.s   .line

        rept    SHORT
        move.b  d0,(a0)+
        endr
.bytes_end
.next   adda.l  d6,a1
        adda.l  a5,a6
        dbra    d7,.line
        rts

.line   move.l  (a1)+,d2                ; --:left
        lea     (a6,d2.w),a0
        move.w  d2,d3
        move.w  (a1)+,d2
        sub.w   d3,d2                   ; pixels - 1
        bmi.s   .next
        cmp.w   #SHORT,d2
        bhs.s   .long
        neg.w   d2                      ; 2 bytes of code a pixel
        jmp     (a4,d2.w*2)

.long   addq.w  #1,d2
        move.w  a0,d3
        btst    #0,d3
        beq.s   .even
        move.b  d0,(a0)+
        subq.w  #1,d2
        addq.w  #1,d3
.even   btst    #1,d3
        beq.s   .aligned
        move.w  d0,(a0)+
        subq.w  #2,d2
.aligned
        move.w  d2,d3
        lsr.w   #2,d3                   ; longwords
        fill_longwords
        btst    #1,d2
        beq.s   .last
        move.w  d0,(a0)+
.last   btst    #0,d2
        beq     .next
        move.b  d0,(a0)+
        bra     .next
