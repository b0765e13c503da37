        include "routine.i"

; box_fill - fills a box of a frame with one colour
;
; in:      a0  const struct box_plan*  the box
; writes:  longwords of the box's rows, nothing else
; formats: pixels of 1, 2 or 4 bytes

LOOP    equ     32                      ; longwords

        routine box_fill,a0
        movem.l d2-d4/a2-a3,-(sp)
        movem.l (a0),d1-d4/a1           ; first, longwords, rows, pitch, pixels
        movea.l d1,a0
        move.l  a1,d0
        moveq   #LOOP-1,d1
        and.w   d2,d1
        neg.w   d1                      ; 2 bytes of code a longword
        lea     .longwords_end(pc),a3
        lea     (a3,d1.w*2),a3          ; where a row begins in the loop
        move.l  d2,d1
        lsl.l   #2,d1
        sub.l   d1,d4
        movea.l d4,a2                   ; from a row's end to the next
        lsr.l   #5,d2                   ; LOOP
        subq.l  #1,d3
.row    move.l  d2,d1
        jmp     (a3)
.longwords
        rept    LOOP
        move.l  d0,(a0)+
        endr
.longwords_end
        dbra    d1,.longwords
        adda.l  a2,a0
        dbra    d3,.row
        movem.l (sp)+,d2-d4/a2-a3
        rts
