; Takes keys before any window gets them, by a handler of input.device ahead of the system's.

        include "amiga.i"

        xref    at_end

PRIORITY                equ     60      ; the system's own is at 50
RING                    equ     16      ; keys that wait; a power of two

; keys_open - takes keys and mouse from the system, until keys_close or the end
;
; out:     d0  int32  1 taken, 0 not
; error:   0 if memory is short, or they are taken already
        routine keys_open
        movem.l d2/a6,-(sp)
        moveq   #0,d2
        tst.l   port
        bne.s   .done
        clr.w   first
        movea.l sys_base,a6
        suba.l  a1,a1
        lvo     FindTask
        move.l  d0,task
        lea     ending,a0
        jsr     at_end
        lvo     CreateMsgPort
        move.l  d0,port
        beq.s   .done
        movea.l d0,a0
        moveq   #IOStdReq_SIZE,d0
        lvo     CreateIORequest
        move.l  d0,request
        beq.s   .failed
        lea     .name(pc),a0
        movea.l d0,a1
        moveq   #0,d0
        moveq   #0,d1
        lvo     OpenDevice
        tst.b   d0
        bne.s   .failed
        st      is_open
        moveq   #IND_ADDHANDLER,d0
        bsr.s   tell
        moveq   #1,d2
        bra.s   .done
.failed jsr     keys_close
.done   move.l  d2,d0
        movem.l (sp)+,d2/a6
        rts
.name   dc.b    'input.device',0
        even

; Sends command d0 to input.device; a6 = exec.
tell    movea.l request,a1
        move.w  d0,io_Command(a1)
        move.l  #handler,io_Data(a1)
        lvo     DoIO
        rts

; keys_close - gives keys and mouse back
;
; error:   does nothing if they are not ours
        routine keys_close
        move.l  a6,-(sp)
        movea.l sys_base,a6
        tst.b   is_open
        beq.s   .closed
        sf      is_open
        moveq   #IND_REMHANDLER,d0
        bsr.s   tell
        movea.l request,a1
        lvo     CloseDevice
.closed move.l  request,d0
        beq.s   .no_request
        clr.l   request
        movea.l d0,a0
        lvo     DeleteIORequest
.no_request
        move.l  port,d0
        beq.s   .done
        clr.l   port
        movea.l d0,a0
        lvo     DeleteMsgPort
.done   movea.l (sp)+,a6
        rts

; key_take - the next key that was pressed
;
; out:     d0  uint32  its raw code, 0 to $7f, or $ffffffff: none
; writes:  the keys that wait
; error:   while 15 keys wait, further ones are dropped
        routine key_take
        moveq   #-1,d0
        moveq   #0,d1
        move.b  first,d1
        cmp.b   last,d1
        beq.s   .none
        moveq   #0,d0
        lea     ring,a0
        move.b  (a0,d1.w),d0
        addq.b  #1,d1
        and.b   #RING-1,d1
        move.b  d1,first
.none   rts

; Called by the task of input.device with the events in a0; returns in d0 the events for the
; next handlers.
        section .text.key_handler,code
handle: move.l  a0,-(sp)
.event  move.l  a0,d0
        beq.s   .done
        move.b  ie_Class(a0),d0
        cmp.b   #IECLASS_RAWMOUSE,d0
        beq.s   .swallow
        cmp.b   #IECLASS_RAWKEY,d0
        bne.s   .next
        bsr.s   pressed
.swallow
        move.b  #IECLASS_NULL,ie_Class(a0)
.next   movea.l (a0),a0
        bra.s   .event
.done   move.l  (sp)+,d0
        rts

; Handles the event a0 of a key.
pressed move.w  ie_Code(a0),d0
        btst    #7,d0                   ; released
        bne.s   .done
        move.w  ie_Qualifier(a0),d1
        btst    #IEQUALIFIERB_REPEAT,d1
        bne.s   .done
        btst    #IEQUALIFIERB_CONTROL,d1
        beq.s   .plain
        cmp.b   #C_KEY,d0
        beq.s   .break
.plain  moveq   #0,d1
        move.b  last,d1
        lea     ring,a1
        move.b  d0,(a1,d1.w)
        addq.b  #1,d1
        and.b   #RING-1,d1
        cmp.b   first,d1
        beq.s   .done
        move.b  d1,last
.done   rts
.break  movem.l a0/a6,-(sp)
        movea.l sys_base,a6
        movea.l task,a1
        move.l  #SIGBREAKF_CTRL_C,d0
        lvo     Signal
        movem.l (sp)+,a0/a6
        rts

        section .data.keys,data
handler dc.l    0,0
        dc.b    2,PRIORITY              ; NT_INTERRUPT
        dc.l    handler_name,0,handle
ending  dc.l    0,keys_close            ; struct end
handler_name
        dc.b    'tmap020 keys',0
        even

        section .bss.keys,bss
task            ds.l    1
port            ds.l    1
request         ds.l    1
first           ds.b    1               ; index of the first key that waits
last            ds.b    1               ; index after the last one
is_open         ds.b    1
ring            ds.b    RING
