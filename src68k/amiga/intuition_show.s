; The bitmaps of a screen of Intuition's in turn, and the messages that say when one is shown.

        include "intuition.i"

        xdef    intuition_settle

; intuition_show - shows a bitmap from the next field on
;
; in:      a0  struct intuition*  an open one
;          d0  int32              which: 0 or 1
; writes:  what is shown
; error:   waits while Intuition cannot change it, as when the user drags the screen, and for the bitmap before
        routine intuition_show,a0,d0
        movem.l d2/a2/a6,-(sp)
        movea.l a0,a2
        move.l  d0,d2
        jsr     intuition_settle
        bra.s   .ask
.again  movea.l intuition_graphics_base(a2),a6
        lvo     WaitTOF
.ask    move.l  intuition_fields(a2),d0
        addq.l  #1,d0
        move.l  d0,intuition_since(a2)
        tst.l   intuition_buffer+4(a2)
        beq.s   .done                   ; one bitmap: it is shown
        movea.l intuition_intuition_base(a2),a6
        movea.l intuition_screen(a2),a0
        movea.l intuition_buffer(a2,d2.l*4),a1
        lvo     ChangeScreenBuffer
        tst.l   d0
        beq.s   .again
        moveq   #2,d0
        move.l  d0,intuition_asked(a2)
.done   movem.l (sp)+,d2/a2/a6
        rts

; intuition_waits - whether the bitmap that was asked for is still to be shown
;
; in:      a0  struct intuition*  an open one
; out:     d0  int32              1 if so, 0 if it is shown
; writes:  the messages that have come
        routine intuition_waits,a0
        movem.l a2/a6,-(sp)
        movea.l a0,a2
        movea.l sys_base,a6
        jsr     take_messages
        moveq   #1,d0
        tst.l   intuition_asked(a2)
        bne.s   .done
        move.l  intuition_fields(a2),d1
        sub.l   intuition_since(a2),d1
        bmi.s   .done
        moveq   #0,d0
.done   movem.l (sp)+,a2/a6
        rts

; intuition_wait - waits until the bitmap that was asked for is shown, and the one before is free
;
; in:      a0  struct intuition*  an open one
; writes:  the messages that come
; cost:    a field or two

; A system whose messages come at once, as AROS's do, is waited for by the field.
        routine intuition_wait,a0
        movem.l a2/a6,-(sp)
        movea.l a0,a2
        jsr     intuition_settle
        movea.l intuition_graphics_base(a2),a6
.field  move.l  intuition_fields(a2),d0
        sub.l   intuition_since(a2),d0
        bpl.s   .done
        lvo     WaitTOF
        bra.s   .field
.done   movem.l (sp)+,a2/a6
        rts

; intuition_field - waits for the next field
;
; in:      a0  struct intuition*  an open one
; cost:    a field at most
        routine intuition_field,a0
        move.l  a6,-(sp)
        movea.l intuition_graphics_base(a0),a6
        lvo     WaitTOF
        movea.l (sp)+,a6
        rts

        section .text.intuition_messages,code
        cnop    0,4
; intuition_settle - waits for the messages of the bitmap that was asked for
;
; in:      a2  struct intuition*  its buffers are there
; out:     a6  struct ExecBase*   exec
; writes:  the messages that come
intuition_settle
        movea.l sys_base,a6
.wait   tst.l   intuition_asked(a2)
        beq.s   .done
        movea.l intuition_port(a2),a0
        lvo     WaitPort
        bsr.s   take_messages
        bra.s   .wait
.done   rts

; Takes the messages of a2 that have come; a6 = exec.
take_messages
        movea.l intuition_port(a2),a0
        lvo     GetMsg
        tst.l   d0
        beq.s   .done
        subq.l  #1,intuition_asked(a2)
        bra.s   take_messages
.done   rts
