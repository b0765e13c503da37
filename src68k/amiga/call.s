; Calls a routine with given registers and records them after the call. The bench
; and the tests call every kernel this way, by its contract.

        include "amiga.i"

REGISTERS               equ     15      ; d0-d7/a0-a6
CACHE_SIZE              equ     256     ; the 68020's, in bytes

; call_kernel - calls a routine once
;
; in:      a0  int32*  d0-d7/a0-a6 for it, then one longword more
;          d0  void*   the routine
; reads:   the block
; writes:  the block: the registers after the call, then by how much the stack
;          pointer was off

; The value for a0 is on the stack too: C's first argument.

        routine call_kernel,a0,d0
        save_all
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
        return_all

; call_place - puts the calling loop where it and a routine share no cache line
;
; in:      a0  const void*  the routine that call_repeat will call

; The 68020's instruction cache is direct-mapped: the lines that two pieces of code
; share depend on their addresses modulo 256. The loop ends where the routine begins,
; modulo 256. So a figure depends on the routine alone, wherever the linker and
; AmigaDOS put code; routines of up to 256 - LOOP_SIZE bytes stay cached.

        routine call_place,a0
        save_all
        move.l  a0,kernel
        lea     room,a1
        move.l  a0,d0
        sub.l   #LOOP_SIZE,d0
        sub.l   a1,d0
        and.l   #CACHE_SIZE-1,d0
        adda.l  d0,a1
        move.l  a1,loop
        lea     calling_loop(pc),a0
        moveq   #LOOP_SIZE/4-1,d0
.copy   move.l  (a0)+,(a1)+
        dbra    d0,.copy
        movea.l sys_base,a6
        lvo     CacheClearU
        return_all

; Runs as a copy only.
        cnop    0,4
calling_loop
        movem.l registers,d0-d7/a0-a6
        move.l  a0,-(sp)                ; C's first argument
        jsr     ([kernel])
        addq.l  #4,sp
        subq.l  #1,calls
        bne.s   calling_loop
        rts
        cnop    0,4
LOOP_SIZE               equ     *-calling_loop

; call_repeat - calls call_place's routine again and again, with the same registers
;
; in:      a0  const int32*  d0-d7/a0-a6 for it
;          d0  int32   how often, 1 or more
; cost:    the same for every routine: measure one that only returns
        routine call_repeat,a0,d0
        save_all
        move.l  d0,calls
        lea     registers,a1
        moveq   #REGISTERS-1,d1
.copy   move.l  (a0)+,(a1)+
        dbra    d1,.copy
        jsr     ([loop])
        return_all

        section .bss.call,bss
kernel          ds.l    1
stack           ds.l    1
calls           ds.l    1
loop            ds.l    1
registers       ds.l    REGISTERS
room            ds.b    CACHE_SIZE+LOOP_SIZE
