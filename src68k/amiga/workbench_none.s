; For programs of one scene, which a double click does not run.

        include "amiga.i"

        xdef    workbench_none

; workbench_none - started by a double click: replies and leaves
;
; in:      a4  struct Process*  this task
;          a6  struct ExecBase*  exec
; out:     d0  int32  return code 20
; trashes: everything
; reads:   the start-up message

; On the stack are d2-d7/a2-a6, as start saved them. Such programs link it in place of workbench.
        section .text.workbench_none,code
workbench_none:
        lea     pr_MsgPort(a4),a0
        lvo     WaitPort
        lea     pr_MsgPort(a4),a0
        lvo     GetMsg
        move.l  d0,d2
        lvo     Forbid                  ; until our code is unloaded
        movea.l d2,a1
        lvo     ReplyMsg
        moveq   #RETURN_FAIL,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts
