; Keys that are pressed while a program runs, one each KEY_FIELDS: a part of endings.s.

_LVOBeginIO             equ     -30     ; of a device
io_Device               equ     20
KEY_FIELDS              equ     30
CURSOR_LEFT             equ     $4f
SPACE                   equ     $40
ESCAPE                  equ     $45

keys_set:
        move.l  #key_field,server_code
        moveq   #KEY_FIELDS,d0
        move.l  d0,fields
        clr.w   key+ie_Qualifier
        bra     open_input

; Nobody waits for these requests: they have no port to return to, and are done long before the next.
key_field:
        subq.l  #1,fields
        bne.s   .not_yet
        movea.l next_key,a0
        moveq   #0,d0
        move.b  (a0),d0
        beq.s   .not_yet
        addq.l  #1,next_key
        move.w  d0,key+ie_Code
        move.b  #IECLASS_RAWKEY,key+ie_Class    ; who takes an event changes it
        moveq   #KEY_FIELDS,d0
        move.l  d0,fields
        move.l  a6,-(sp)
        lea     request,a1
        movea.l io_Device(a1),a6
        lvo     BeginIO
        movea.l (sp)+,a6
.not_yet
        lea     custom,a0
        moveq   #0,d0
        rts

        section .data.keys_pressed,data
        cnop    0,4
next_key        dc.l    key_table
; Cursor left, which the demo does not know; of escape the end alone.
key_table       dc.b    CURSOR_LEFT,SPACE,ESCAPE|IECODE_UP,SPACE,ESCAPE,0
