        include "amiga.i"

; instructions - runs given code, with which the bench measures single instructions
;
; in:      d7  int32  rounds of that code, less one
;          a4  void*  the code: it counts d7 down and returns
; out:     d0  uint32  the code's d0
; trashes: d1-d7/a0-a6
; reads:   the code, as does the code itself
; writes:  as the code does
; cost:    bench row instruction_none, whose code is a dbra

; The code has just been copied there, so the cache is cleared first.

        routine instructions
        movem.l d0-d1/a0-a1/a6,-(sp)
        movea.l 4.w,a6
        lvo     CacheClearU
        movem.l (sp)+,d0-d1/a0-a1/a6
        jmp     (a4)
