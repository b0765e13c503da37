; Calls a routine with any registers and notes what it leaves in them: how the
; bench and the tests reach every kernel by its contract.

        include "routine.i"

REGISTERS               equ     15      ; d0-d7/a0-a6

;==============================================================================
; call_kernel - calls a routine once
;
; in:      a0  int32*  d0-d7/a0-a6 for it, then one longword more
;          d0  void*   the routine
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the block
; writes:  the block: the registers after the call, then by how much the stack
;          pointer was off
; formats: -
; error:   -
; cost:    -
;==============================================================================
; The value for a0 lies on the stack too: C's first argument.

        routine call_kernel,a0,d0
        movem.l d2-d7/a2-a6,-(sp)
        move.l  a0,-(sp)
        move.l  d0,kernel
        movem.l (a0),d0-d7/a0-a6
        move.l  a0,-(sp)
        move.l  sp,stack
        jsr     ([kernel])
        movem.l d0-d7/a0-a6,registers
        move.l  sp,d0
        movea.l stack,sp
        sub.l   sp,d0
        addq.l  #4,sp
        movea.l (sp)+,a0
        lea     registers,a1
        moveq   #REGISTERS-1,d1
.copy   move.l  (a1)+,(a0)+
        dbra    d1,.copy
        move.l  d0,(a0)
        movem.l (sp)+,d2-d7/a2-a6
        rts

;==============================================================================
; call_repeat - calls a routine again and again with the same registers
;
; in:      a0  int32*  d0-d7/a0-a6 for it
;          d0  void*   the routine
;          d1  int32   how often, 1 or more
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the block
; writes:  -
; formats: -
; error:   -
; cost:    the same for every routine: measure one that only returns
;==============================================================================
        routine call_repeat,a0,d0,d1
        movem.l d2-d7/a2-a6,-(sp)
        move.l  d0,kernel
        move.l  d1,calls
        lea     registers,a1
        moveq   #REGISTERS-1,d1
.copy   move.l  (a0)+,(a1)+
        dbra    d1,.copy
.call   movem.l registers,d0-d7/a0-a6
        move.l  a0,-(sp)
        jsr     ([kernel])
        addq.l  #4,sp
        subq.l  #1,calls
        bne.s   .call
        movem.l (sp)+,d2-d7/a2-a6
        rts

        section .bss.call,bss
kernel          ds.l    1
stack           ds.l    1
calls           ds.l    1
registers       ds.l    REGISTERS
