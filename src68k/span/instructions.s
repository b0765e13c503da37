        include "routine.i"
        include "amiga.i"

;==============================================================================
; instructions - runs code that a plan holds: how the bench prices single instructions
;
; in:      d7  int32  rounds of that code, less one
;          a4  void*  the code: it counts d7 down and returns
; out:     d0  uint32  what the code leaves there
; trashes: d1-d7/a0-a6
; reads:   the code, what it reads
; writes:  what the code writes
; error:   none
; cost:    bench row instruction_none, whose code is a dbra
;==============================================================================
; The code was copied to its place a moment ago.

        routine instructions
        movem.l d0-d1/a0-a1/a6,-(sp)
        movea.l 4.w,a6
        lvo     CacheClearU
        movem.l (sp)+,d0-d1/a0-a1/a6
        jmp     (a4)
