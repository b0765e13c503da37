        include "routine.i"

        xref    still_picture

; still_draw - draws the one picture of a program in which nothing moves
;
; reads:   the calls still_picture
; writes:  the frame
        routine still_draw
        lea     still_picture,a0

; still_calls - calls routines, each with its argument on the stack
;
; in:      a0  struct still_call*  the first; a routine of 0 ends them
; trashes: d0-d1/a0-a1
still_calls
        move.l  a2,-(sp)
        movea.l a0,a2
.call   move.l  (a2)+,d0
        beq.s   .done
        movea.l d0,a0
        move.l  (a2)+,-(sp)
        jsr     (a0)
        addq.l  #4,sp
        bra.s   .call
.done   movea.l (sp)+,a2
        rts

        xdef    still_calls
