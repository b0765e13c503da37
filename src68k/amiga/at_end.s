; What a program has taken of the machine and gives back at its end, whichever way it ends.

        include "amiga.i"
        include "routine.i"

        xdef    at_end
        xref    end_first
        xref    quiet_leave

AT_NEXT                 equ     0
AT_ROUTINE              equ     4

;==============================================================================
; at_end - has a routine called when the program ends: the last one given comes first
;
; in:      a0  int32*  two longwords that are 0 before the first call; they belong to the list
;          a1  void*   the routine, which may be called after it was called otherwise: keeps
;                      d2-d7/a2-a6
; out:     -
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  the list
; formats: -
; error:   what is in the list already stays where it is
; cost:    -
;==============================================================================
        section .text.at_end,code
at_end: tst.l   AT_ROUTINE(a0)
        bne.s   .listed
        move.l  a1,AT_ROUTINE(a0)
        move.l  list,AT_NEXT(a0)
        move.l  a0,list
        move.l  #end_all,end_first
.listed rts

; A routine that does not return is not called again: each is taken off first.
end_all:
        move.l  #quiet_leave,end_first
        jsr     quiet_leave
.next   move.l  list,d0
        beq.s   .done
        movea.l d0,a0
        move.l  AT_NEXT(a0),list
        movea.l AT_ROUTINE(a0),a1
        clr.l   AT_ROUTINE(a0)
        jsr     (a1)
        bra.s   .next
.done   rts

        section .bss.at_end,bss
list            ds.l    1
