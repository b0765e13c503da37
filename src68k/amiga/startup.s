; Start and end of every program: libraries, the fault handler, and the release
; of all that is still held, whichever way the program ends.

        include "amiga.i"

        xdef    start
        xdef    program_end
        xdef    sys_base
        xdef    dos_base
        xdef    end_first
        xref    _main
        xref    fault_handler
        xref    quiet_leave
        xref    clock_close
        xref    file_close_all
        xref    mem_free_all

RETURN_FAIL             equ     20

;==============================================================================
; start - entry of a CLI program: calls int main(void), returns what it returns
;
; in:      -
; out:     d0  int32  AmigaDOS return code: 0, 5, 10 or 20
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  the task's trap vector, restored at the end
; formats: -
; error:   started from Workbench: replies and leaves; no dos 36: returns 20
; cost:    -
;==============================================================================
        section .text.start,code
start:
        movem.l d2-d7/a2-a6,-(sp)
        movea.l 4.w,a6
        move.l  a6,sys_base
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a4
        tst.l   pr_CLI(a4)
        beq.s   from_workbench
        lea     dos_name(pc),a1
        moveq   #36,d0
        lvo     OpenLibrary
        move.l  d0,dos_base
        beq     no_dos
        move.l  tc_TrapCode(a4),old_trap_code
        move.l  #fault_handler,tc_TrapCode(a4)
        move.l  a4,this_task
        move.l  sp,initial_sp
        jsr     _main

;==============================================================================
; program_end - ends the program from anywhere, in user mode
;
; in:      d0  int32  AmigaDOS return code
; out:     -
; trashes: -
; reads:   -
; writes:  -
; formats: -
; error:   never returns to its caller
; cost:    -
;==============================================================================
program_end:
        movea.l initial_sp,sp
        move.l  d0,d2
        movea.l end_first,a0            ; see at_end
        jsr     (a0)
        jsr     clock_close
        jsr     file_close_all
        jsr     mem_free_all
        movea.l this_task,a4
        move.l  old_trap_code,tc_TrapCode(a4)
        movea.l sys_base,a6
        movea.l dos_base,a1
        lvo     CloseLibrary
        move.l  d2,d0
        bra.s   leave_program

from_workbench
        lea     pr_MsgPort(a4),a0
        lvo     WaitPort
        lea     pr_MsgPort(a4),a0
        lvo     GetMsg
        move.l  d0,d2
        lvo     Forbid                  ; until our code is unloaded
        movea.l d2,a1
        lvo     ReplyMsg
no_dos moveq   #RETURN_FAIL,d0
leave_program  movem.l (sp)+,d2-d7/a2-a6
        rts

dos_name        dc.b    'dos.library',0
                even

        section .data.startup,data
end_first       dc.l    quiet_leave

        section .bss.startup,bss
sys_base        ds.l    1
dos_base        ds.l    1
this_task       ds.l    1
old_trap_code   ds.l    1
initial_sp      ds.l    1
