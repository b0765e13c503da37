; What is given back at a program's end beside memory, files and timers: routines that closed
; displays, handlers and the like have put themselves in line for it.

        include "amiga.i"
        include "layout.i"
        include "routine.i"

        xref    ends_call

;==============================================================================
; at_end - has a routine called at the program's end, whichever way that comes
;
; in:      a0  struct end*   static; `next` as the program was loaded with it: 0
; reads:   the chain
; writes:  the chain
; error:   what is in the chain stays there once
;==============================================================================
; The last one in is called first, before timers, files and memory go back. Routines keep
; d2-d7/a2-a6 and do nothing where they have nothing to close: they stay in the chain when a
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

; Each leaves the chain before it is called: a crash in one leaves the others to be called.
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
