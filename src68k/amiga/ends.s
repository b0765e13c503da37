; The chain of routines that are called at a program's end, to close displays, handlers and the
; like, before memory, files and timers are released.

        include "amiga.i"

        xref    ends_call

; at_end - registers a routine to be called at the program's end, however it ends
;
; in:      a0  struct end*   static; `next` is 0 in the program file
; reads:   the chain
; writes:  the chain
; error:   a struct that is in the chain already is not added again

; The last one added is called first, before timers, files and memory are released. Routines
; keep d2-d7/a2-a6 and do nothing if there is nothing to close: they stay in the chain when a
; program closes something itself.

        routine at_end,a0
        lea     ends,a1
.look   move.l  (a1),d0                 ; end_next, the first field
        beq.s   .new
        movea.l d0,a1
        cmpa.l  a1,a0
        bne.s   .look
        rts
.new    move.l  ends,end_next(a0)
        move.l  a0,ends
        move.l  #call_all,ends_call
        rts

; Each is taken out of the chain before it is called: after a crash in one the others are still
; called.
call_all:
        move.l  ends,d0
        beq.s   .done
        movea.l d0,a0
        move.l  end_next(a0),ends
        clr.l   end_next(a0)
        movea.l end_routine(a0),a0
        jsr     (a0)
        bra.s   call_all
.done   rts

        section .bss.ends,bss
ends            ds.l    1
