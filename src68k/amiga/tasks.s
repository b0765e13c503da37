; Keeps other tasks from running: a measured time includes theirs.

        include "amiga.i"

; tasks_forbid - lets no other task run until tasks_permit; interrupts go on
;
; Nothing may wait in between: exec lets other tasks run in Wait.
        routine tasks_forbid
        move.l  a6,-(sp)
        movea.l sys_base,a6
        lvo     Forbid
        movea.l (sp)+,a6
        rts

; tasks_permit - ends tasks_forbid: tasks that are ready run before it returns
        routine tasks_permit
        move.l  a6,-(sp)
        movea.l sys_base,a6
        lvo     Permit
        movea.l (sp)+,a6
        rts
