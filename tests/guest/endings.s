; Runs a program as a shell or a double click does; prints the machine's state before and after,
; and how the program ended. For tests only.
;
;       endings LOG HOW DRAWER PROGRAM ARGUMENTS
;
; The program's output goes to LOG. HOW is 0, or the number of fields until a Ctrl-C, -1 at once;
; -2 is a double click on the program in DRAWER, then Ctrl-\ is pressed in the window titled
; tmap020; -3 is 0 with DRAWER as the current directory, -4 is 0 with Kickstart 1.3's version of dos;
; with -5 the keys of key_table are pressed, one each KEY_FIELDS.

        include "amiga.i"
        include "routine.i"

        xref    args_read
        xref    program_load
        xref    program_unload
        xref    program_run
        xref    dos_base
        xref    state
        xref    _text_number
        xref    _text_print

_LVOPutMsg              equ     -366
_LVOUnLock              equ     -90
_LVOLock                equ     -84
_LVOCreateNewProc       equ     -498
ACCESS_READ             equ     -2
ib_FirstScreen          equ     60
sc_FirstWindow          equ     4
wd_Title                equ     32
IND_WRITEEVENT          equ     11
NP_Seglist              equ     $800003e9
NP_FreeSeglist          equ     $800003ea

AT_ONCE                 equ     -1      ; HOW
DOUBLE_CLICK            equ     -2
IN_DRAWER               equ     -3
OLD_KICKSTART           equ     -4
KEYS                    equ     -5

        routine main
        movem.l d2-d7/a2-a6,-(sp)
        move.l  #template,d0
        move.l  #items,d1
        jsr     args_read
        lea     line,a1
        move.l  arguments,d0
        beq.s   .no_arguments
        movea.l d0,a0
.copy   move.b  (a0)+,(a1)+
        bne.s   .copy
        subq.l  #1,a1
.no_arguments
        move.b  #10,(a1)+
        suba.l  #line,a1
        move.l  a1,length
        movea.l sys_base,a6
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a4
        movea.l how,a0
        move.l  (a0),d5
        cmpi.l  #DOUBLE_CLICK,d5
        bgt.s   .stay
        cmpi.l  #IN_DRAWER,d5
        blt.s   .stay
        move.l  drawer_name,d1
        moveq   #ACCESS_READ,d2
        movea.l dos_base,a6
        lvo     Lock
        move.l  d0,drawer
        cmpi.l  #IN_DRAWER,d5
        bne.s   .stay
        move.l  d0,d1
        lvo     CurrentDir
        move.l  d0,home
.stay
        jsr     state
        move.l  program,d0
        jsr     program_load
        move.l  d0,d7
        cmpi.l  #DOUBLE_CLICK,d5
        beq     .double
        bsr     alarm_set
        movea.l dos_base,a3
        move.w  lib_Version(a3),d4
        cmpi.l  #OLD_KICKSTART,d5
        bne.s   .as_it_is
        move.w  #34,lib_Version(a3)
.as_it_is
        move.l  d7,d0
        move.l  #line,d1
        movea.l length,a0
        movea.l output,a1
        jsr     program_run
        move.w  d4,lib_Version(a3)
        move.l  d0,d6
        bsr     alarm_clear
        bra.s   .ended
.double bsr     double_click
        move.l  d0,d6
.ended  move.l  d7,d0
        jsr     program_unload
        jsr     state
        move.l  d6,-(sp)
        jsr     _text_number
        addq.l  #4,sp
        jsr     _text_print
        movea.l dos_base,a6
        cmpi.l  #IN_DRAWER,d5
        bne.s   .at_home
        move.l  home,d1
        lvo     CurrentDir
.at_home
        move.l  drawer,d1               ; UnLock takes 0
        lvo     UnLock
        moveq   #0,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts

alarm_set:
        movea.l sys_base,a6
        move.l  a4,task
        move.l  d5,fields
        cmpi.l  #AT_ONCE,d5
        beq     ring
        cmpi.l  #KEYS,d5
        bne.s   .no_keys
        bsr     keys_set
        bra.s   .add
.no_keys
        tst.l   d5
        ble.s   no_alarm
.add    lea     server,a1
        moveq   #INTB_VERTB,d0
        lvo     AddIntServer
no_alarm
        rts

alarm_clear:
        movea.l sys_base,a6
        cmpi.l  #KEYS,d5
        bne.s   .no_keys
        lea     request,a1
        lvo     CloseDevice
        bra.s   .remove
.no_keys
        tst.l   d5
        ble.s   no_alarm
.remove lea     server,a1
        moveq   #INTB_VERTB,d0
        jmp     _LVORemIntServer(a6)

open_input:
        lea     input_name,a0
        moveq   #0,d0
        lea     request,a1
        moveq   #0,d1
        jmp     _LVOOpenDevice(a6)

field:  subq.l  #1,fields
        bne.s   .not_yet
        movea.l sys_base,a6
        bsr.s   ring
.not_yet
        lea     custom,a0
        moveq   #0,d0
        rts

ring:   movea.l task,a1
        move.l  #SIGBREAKF_CTRL_C,d0
        jmp     _LVOSignal(a6)

; d7 = the program. d0 = 2 if it opened a window that stayed and a key then closed, 1 if the window
; cannot be closed, else 0.
double_click:
        movem.l d2-d7/a2-a6,-(sp)
        movea.l sys_base,a6
        lea     intuition_name,a1
        moveq   #0,d0
        lvo     OpenLibrary
        movea.l d0,a2
        lvo     CreateMsgPort
        movea.l d0,a3
        move.l  d0,startup+14
        move.l  d0,request+14
        bsr     open_input
        lsr.l   #2,d7
        move.l  d7,seglist
        move.l  #tags,d1
        movea.l dos_base,a6
        lvo     CreateNewProc
        movea.l d0,a5
        movea.l sys_base,a6
        lea     pr_MsgPort(a5),a0
        lea     startup,a1
        lvo     PutMsg
        movea.l a3,a0
        lvo     WaitPort
        movea.l a3,a0
        lvo     GetMsg
        bsr.s   pause                   ; until the process has ended, too
        moveq   #0,d6
        bsr.s   find_window
        tst.l   d0
        beq.s   .close
        moveq   #1,d6
        lea     request,a1
        lvo     DoIO
        bsr.s   pause
        bsr.s   find_window
        tst.l   d0
        bne.s   .close
        moveq   #2,d6
.close  lea     request,a1
        lvo     CloseDevice
        movea.l a3,a0
        lvo     DeleteMsgPort
        movea.l a2,a1
        lvo     CloseLibrary
        move.l  d6,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts

pause:  move.l  a6,-(sp)
        moveq   #25,d1
        movea.l dos_base,a6
        lvo     Delay
        movea.l (sp)+,a6
        rts

; d0 = the first window of our title, or 0. a2 = intuition.
find_window:
        move.l  ib_FirstScreen(a2),d1
.screen movea.l d1,a0
        tst.l   d1
        beq.s   .none
        move.l  sc_FirstWindow(a0),d0
.window beq.s   .next
        movea.l d0,a1
        move.l  wd_Title(a1),d1
        beq.s   .other
        movea.l d1,a1
        cmpi.l  #'tmap',(a1)
        beq.s   .found
.other  movea.l d0,a1
        move.l  (a1),d0
        bra.s   .window
.next   move.l  (a0),d1
        bra.s   .screen
.none   moveq   #0,d0
.found  rts

        include "tests/guest/keys.i"

        section .data.endings,data
        cnop    0,4
server  dc.l    0,0
        dc.b    2,0
        dc.l    blank,0
server_code
        dc.l    field
        cnop    0,4
tags    dc.l    NP_Seglist
seglist dc.l    0,NP_FreeSeglist,0,0
startup dc.l    0,0,0                   ; struct WBStartup
        dc.w    0
        dc.l    0
        dc.w    40
        dc.l    0,0,1,0,drawer
drawer  dc.l    0,blank                 ; struct WBArg
request dc.l    0,0,0                   ; struct IOStdReq
        dc.w    0
        dc.l    0
        dc.w    48
        dc.l    0,0
        dc.w    IND_WRITEEVENT
        dc.w    0
        dc.l    0,22,key,0
key     dc.l    0                       ; struct InputEvent: Ctrl-\, the end of a console's input
        dc.b    1,0
        dc.w    $0d,8
        dc.l    0,0,0
template        dc.b    'LOG/A,HOW/A/N,DRAWER/A,PROGRAM/A,ARGUMENTS/F',0
input_name      dc.b    'input.device',0
intuition_name  dc.b    'intuition.library',0
blank           dc.b    ' ',0

        section .bss.endings,bss
items
output          ds.l    1
how             ds.l    1
drawer_name     ds.l    1
program         ds.l    1
arguments       ds.l    1
home            ds.l    1
task            ds.l    1
fields          ds.l    1
length          ds.l    1
line            ds.b    512
