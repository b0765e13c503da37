; Start by a double click: no arguments, but a message to reply to, and a window for the program's
; output.

        include "amiga.i"

        xdef    workbench,no_arguments
        xref    at_end,dos_base,read_args,program_begin

DELAY                   equ     250     ; fiftieths of a second

; workbench - runs the program as from a shell, its output in a window that waits to be closed
;
; in:      a4  struct Process*  this task
;          a6  struct ExecBase*  exec
; out:     d0  int32  return code
; trashes: everything
; reads:   the start-up message
; writes:  the process's input, output and current directory
; error:   without a window the program does not run; returns 20

; On the stack are d2-d7/a2-a6, as start saved them. The window opens with the first line of
; output. Kickstart 1.3 opens it at once and does not wait for its closing, so it stays for DELAY.
        section .text.workbench,code
workbench:
        lea     pr_MsgPort(a4),a0
        lvo     WaitPort
        lea     pr_MsgPort(a4),a0
        lvo     GetMsg
        movea.l d0,a2
        st      by_icon
        moveq   #RETURN_FAIL,d3
        lea     dos_name(pc),a1
        moveq   #0,d0
        lvo     OpenLibrary
        movea.l d0,a5
        exg     a5,a6
        move.l  #window,d1
        move.l  #FILE_OLD,d2
        lvo     Open
        move.l  d0,d4
        beq.s   .no_window
        move.l  d4,pr_CIS(a4)
        move.l  d4,pr_COS(a4)
        movea.l sm_ArgList(a2),a0
        move.l  wa_Lock(a0),d1          ; the program's drawer
        lvo     CurrentDir
        move.l  d0,d5
        exg     a5,a6
        pea     .ended(pc)
        movem.l d2-d7/a2-a6,-(sp)
        jmp     program_begin
.ended  move.l  d0,d3
        exg     a5,a6
        move.l  d5,d1
        lvo     CurrentDir
        cmpi.w  #36,lib_Version(a6)
        bhs.s   .waits
        move.l  #DELAY,d1
        lvo     Delay
.waits  clr.l   pr_CIS(a4)
        clr.l   pr_COS(a4)
        move.l  d4,d1
        lvo     Close
.no_window
        exg     a5,a6
        movea.l a5,a1
        lvo     CloseLibrary
        lvo     Forbid                  ; until our code is unloaded
        movea.l a2,a1
        lvo     ReplyMsg
        move.l  d3,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts
dos_name        dc.b    'dos.library',0
                even

; no_arguments - keeps ReadArgs from waiting for a line from the window
;
; out:     d0  struct RDArgs*  an empty line of arguments, freed at the program's end; 0 if the
;                              program was started from a shell, or memory is short
        section .text.no_arguments,code
no_arguments:
        tst.b   by_icon
        bne.s   .icon
        moveq   #0,d0
        rts
.icon   movem.l d2/a6,-(sp)
        moveq   #DOS_RDARGS,d1
        moveq   #0,d2
        movea.l dos_base,a6
        lvo     AllocDosObject
        move.l  d0,empty
        beq.s   .short
        movea.l d0,a0
        move.l  #line,RDA_Source(a0)
        moveq   #1,d1
        move.l  d1,RDA_Source+CS_Length(a0)
        move.l  #RDAF_NOPROMPT,RDA_Flags(a0)
        lea     args_end,a0
        jsr     at_end
.short  move.l  empty,d0
        movem.l (sp)+,d2/a6
        rts

free_empty:
        movem.l d2/a6,-(sp)
        movea.l dos_base,a6
        move.l  read_args,d1            ; before its RDArgs; FreeArgs accepts 0
        clr.l   read_args
        lvo     FreeArgs
        moveq   #DOS_RDARGS,d1
        move.l  empty,d2
        lvo     FreeDosObject
        movem.l (sp)+,d2/a6
        rts

        section .data.workbench,data
args_end        dc.l    0,free_empty    ; struct end
line            dc.b    10
window          dc.b    'CON:0/20/640/120/tmap020/AUTO/CLOSE/WAIT',0

        section .bss.workbench,bss
empty           ds.l    1
by_icon         ds.b    1
