; Calls of the system for the test program display.

        include "amiga.i"
        include "routine.i"

io_Length               equ     36
IND_WRITEEVENT          equ     11

        routine spin                    ; a few milliseconds in the cache, without data
        move.w  #20000-1,d0
.again  dbra    d0,.again
        rts

        routine send_event,d0,d1,a0     ; class, code, qualifier, as if a device did
        movem.l d2/a2/a3/a6,-(sp)
        lea     event,a2
        clr.l   (a2)
        move.b  d0,ie_Class(a2)
        move.w  d1,ie_Code(a2)
        move.w  a0,ie_Qualifier(a2)
        movea.l sys_base,a6
        lvo     CreateMsgPort
        move.l  d0,d2
        movea.l d0,a0
        moveq   #IOStdReq_SIZE,d0
        lvo     CreateIORequest
        movea.l d0,a3
        lea     .input(pc),a0
        movea.l a3,a1
        moveq   #0,d0
        moveq   #0,d1
        lvo     OpenDevice
        movea.l a3,a1
        move.w  #IND_WRITEEVENT,io_Command(a1)
        move.l  a2,io_Data(a1)
        move.l  #EVENT_BYTES,io_Length(a1)
        lvo     DoIO
        movea.l a3,a1
        lvo     CloseDevice
        movea.l a3,a0
        lvo     DeleteIORequest
        movea.l d2,a0
        lvo     DeleteMsgPort
        movem.l (sp)+,d2/a2/a3/a6
        rts
.input  dc.b    'input.device',0
        even

        routine break_signal            ; d0: not 0 if Ctrl-C was signalled; clears the signal
        move.l  a6,-(sp)
        moveq   #0,d0
        move.l  #SIGBREAKF_CTRL_C,d1
        movea.l sys_base,a6
        lvo     SetSignal
        movea.l (sp)+,a6
        and.l   #SIGBREAKF_CTRL_C,d0
        rts

        routine illegal
        illegal

        section .bss.events,bss
EVENT_BYTES             equ     22
event           ds.b    EVENT_BYTES+2
