; Ctrl-C: a program polls it between two pieces of its work.

        include "amiga.i"

        xref    _print

; break_asked - checks for Ctrl-C, or the command Break
;
; out:     d0  int32  1: end the program, which is printed as AmigaDOS's commands do; 0: go on
; reads:   the task's signals
; writes:  clears the break signal
        routine break_asked
        move.l  a6,-(sp)
        moveq   #0,d0
        move.l  #SIGBREAKF_CTRL_C,d1
        movea.l sys_base,a6
        lvo     SetSignal
        movea.l (sp)+,a6
        and.l   #SIGBREAKF_CTRL_C,d0
        beq.s   .done
        pea     .text(pc)
        jsr     _print
        addq.l  #4,sp
        moveq   #1,d0
.done   rts
.text   dc.b    '***Break',10,0
        even
