; Start and end of every program: checks the machine, opens libraries, installs the fault handler,
; and releases everything that is still held, however the program ends.

        include "amiga.i"

        xdef    start,program_begin,program_end,dos_base,ends_call
        xref    _main,print,fault_handler,workbench,quiet_leave,clock_close,file_close_all
        xref    mem_free_all

DOS_VERSION             equ     36      ; Kickstart 2.0: ReadArgs, RunCommand

; start - entry of a program, from a shell or by a double click
;
; out:     d0  int32  AmigaDOS return code: 0, 5, 10 or 20

; All of it runs on a 68000 and with any Kickstart.
        section .text.start,code
start:
        movem.l d2-d7/a2-a6,-(sp)
        movea.l sys_base,a6
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a4
        tst.l   pr_CLI(a4)
        bne.s   program_begin
        jmp     workbench               ; goes to program_begin, if at all

; program_begin - calls main if the machine has what every program needs
;
; in:      a4  struct Process*   this task
;          a6  struct ExecBase*  exec
; out:     d0  int32  return code, from program_end
; writes:  the task's trap vector
; error:   no 68020 or no Kickstart 2.0: prints so, returns 20

; On the stack are d2-d7/a2-a6. It must run on a 68000, and so must the end of a program that has
; opened nothing.
program_begin:
        move.l  a4,-(sp)
        move.l  tc_TrapCode(a4),-(sp)
        move.l  sp,initial_sp
        lea     dos_name(pc),a1
        moveq   #0,d0
        lvo     OpenLibrary
        move.l  d0,dos_base
        movea.l d0,a0
        move.l  #no_68020,d0
        btst    #AFB_68020,AttnFlags+1(a6)
        beq.s   .lacking
        move.l  #no_kickstart,d0
        cmpi.w  #DOS_VERSION,lib_Version(a0)
        blo.s   .lacking
        move.l  #fault_handler,tc_TrapCode(a4)
        jsr     _main
        bra.s   program_end
.lacking
        jsr     print
        moveq   #RETURN_FAIL,d0

; program_end - ends the program from anywhere, in user mode
;
; in:      d0  int32  AmigaDOS return code
; trashes: -
; error:   never returns to its caller
program_end:
        movea.l initial_sp,sp
        move.l  d0,d2
        jsr     quiet_leave
        move.l  ends_call,d0
        beq.s   .no_ends
        movea.l d0,a0
        jsr     (a0)
.no_ends
        jsr     clock_close
        jsr     file_close_all
        jsr     mem_free_all
        move.l  (sp)+,d0
        movea.l (sp)+,a4
        move.l  d0,tc_TrapCode(a4)
        movea.l sys_base,a6
        movea.l dos_base,a1
        lvo     CloseLibrary
        move.l  d2,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts

dos_name        dc.b    'dos.library',0
                even

        section .rodata.startup,data
no_68020        dc.b    'needs a 68020 or better',10,0
no_kickstart    dc.b    'needs Kickstart 2.0 or later',10,0
                even

        section .bss.startup,bss
dos_base        ds.l    1
initial_sp      ds.l    1
ends_call       ds.l    1               ; calls the routines of at_end; 0 before the first
