        include "routine.i"

; n64_in_c - a routine in C as a pass
;
; in:      a0  const void*  not read
;          a1  void*  its output
;          a2  const n64_in_c*  the routine and its plan
; reads:   what the routine reads
; writes:  what the routine writes
; formats: its own
; cost:    about 60 cycles beside the routine's
        pass    n64_in_c
        move.l  d0,-(sp)
        move.l  a1,-(sp)
        move.l  n64_in_c_plan(a2),-(sp)
        movea.l n64_in_c_routine(a2),a0
        jsr     (a0)
        lea     12(sp),sp
        rts
