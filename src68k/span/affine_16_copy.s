        include "routine.i"

; span_affine_16_copy - span_affine_copy with 16-bit texels and pixels
;
; like:    span_affine_copy
; formats: as span_affine_copy and span_affine_16

; Copies consecutive texels of the map's row, in parts up to the row's end: one texel if
; their number is odd, then longwords. Reading at an offset, not from (a2)+, leaves no gap
; on the bus: it takes 2.6 cycles less a longword in fast RAM, 3.7 in chip RAM. (32-bit texels
; gain nothing over span_affine_32_row in chip RAM, where each takes as long as two.)

ROUND   equ     32              ; longwords

        span span_affine_16_copy
        movea.l span_plan_map(a0),a4
        move.l  span_plan_pitch(a0),d6
        movea.l span_plan_row(a0),a6
        move.l  span_plan_count(a0),d7
        movea.l span_plan_lines(a0),a0
        lea     .next(pc),a5
        lea     .longwords_end(pc),a3
        moveq   #0,d5
        not.b   d5                      ; 255
        bra     .line

.longwords
        move.l  (a2),(a1)+
        nop                             ; makes the first 4 bytes long, as the others
        rept    ROUND-1
        move.l  4*REPTN+4(a2),(a1)+
        endr
.longwords_end
        lea     4*ROUND(a2),a2
        dbra    d2,.longwords
        jmp     (a5)

.empty  addq.l  #4,a0
.next   adda.l  d6,a6
.line   subq.w  #1,d7
        bmi.s   .done
        move.l  (a0)+,d0                ; --:left
        lea     (a6,d0.w*2),a1
        move.l  (a0)+,d2                ; last:Vv
        move.w  d2,d1
        swap    d2
        sub.w   d0,d2                   ; pixels - 1
        bmi.s   .empty
        move.l  (a0)+,d0
        move.b  d0,d1                   ; VU
        and.w   d5,d0
        lea     (a4,d1.w*2),a2
.part   add.w   d2,d0                   ; U of the last pixel
        cmp.w   d5,d0
        bhi.s   .wraps
.run    addq.w  #1,d2
        lsr.w   #1,d2                   ; longwords
        bcc.s   .even
        move.w  (a2)+,(a1)+
.even   moveq   #ROUND-1,d0
        and.w   d2,d0                   ; of the short first round
        lea     -4*ROUND(a2,d0.w*4),a2
        neg.w   d0                      ; 4 bytes of code each
        lsr.w   #5,d2
        jmp     (a3,d0.w*4)

.done   rts

.wraps  sub.w   #256,d0
        move.w  d0,d3                   ; pixels after the row's end - 1
        sub.w   d0,d2
        subq.w  #1,d2
        lea     .more(pc),a5
        bra.s   .run

        ; the next part, from the row's beginning
.more   lea     -256*2(a2),a2
        moveq   #0,d0
        move.w  d3,d2
        lea     .next(pc),a5
        bra.s   .part
