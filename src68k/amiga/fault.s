; Handles a crash of the program: prints exception, PC (as an offset in the code,
; which the host turns into a routine's name) and registers, then ends the program
; in order with return code 20.

        include "amiga.i"

        xdef    fault_handler,fault_enter,fault_number
        xref    start,program_end,quiet_leave,_print

; fault_handler - the task's trap code: notes the fault, resumes at the report
;
; in:      sp  exec's frame: int32 exception number, then the 680x0 frame
; trashes: everything
; writes:  the fault record
        section .text.fault,code
fault_handler:
        move.l  (sp)+,fault_number
fault_enter:                            ; supervisor mode, number noted already
        movem.l d0-d7/a0-a6,fault_registers
        move.l  usp,a0
        move.l  a0,fault_registers+15*4
        move.l  2(sp),fault_pc
        moveq   #0,d0                   ; drop the frame, whatever its format
        move.b  6(sp),d0
        lsr.b   #4,d0
        move.b  .frame_bytes(pc,d0.w),d0
        adda.l  d0,sp
        clr.w   -(sp)                   ; format 0
        pea     fault_report(pc)
        clr.w   -(sp)                   ; user mode
        rte
.frame_bytes
        dc.b    8,8,12,12,8,8,8,8,8,20,32,92,8,8,8,8

; fault_report - prints the fault record and ends the program
;
; trashes: everything
; reads:   the fault record
; formats: "fault: exception N pc $OFFSET", then d0-d7 and a0-a7, hexadecimal
fault_report:
        lea     -64(sp),sp              ; stay clear of the stack in use
        jsr     quiet_leave
        lea     text,a2
        lea     .head(pc),a0
        bsr.s   put_text
        move.l  fault_number,d0
        bsr.s   put_hex
        lea     .pc(pc),a0
        bsr.s   put_text
        move.l  fault_pc,d0
        sub.l   #start,d0
        bsr.s   put_hex
        lea     fault_registers,a3
        moveq   #16-1,d3
.register
        moveq   #10,d0                  ; a line break before d0 and a0
        cmp.w   #16-1,d3
        beq.s   .separator
        cmp.w   #8-1,d3
        beq.s   .separator
        moveq   #' ',d0
.separator
        move.b  d0,(a2)+
        move.l  (a3)+,d0
        bsr.s   put_hex
        dbra    d3,.register
        move.b  #10,(a2)+
        clr.b   (a2)
        pea     text
        jsr     _print
        moveq   #RETURN_FAIL,d0
        jmp     program_end
.head   dc.b    'fault: exception ',0
.pc     dc.b    ' pc ',0
        even

put_text:                               ; (a0) to (a2)
        move.b  (a0)+,(a2)+
        bne.s   put_text
        subq.l  #1,a2
        rts

put_hex:                                ; d0 to (a2), eight digits
        moveq   #8-1,d1
.digit  rol.l   #4,d0
        moveq   #15,d2
        and.l   d0,d2
        move.b  .digits(pc,d2.w),(a2)+
        dbra    d1,.digit
        rts
.digits dc.b    '0123456789abcdef'

        section .bss.fault,bss
fault_number    ds.l    1
fault_pc        ds.l    1
fault_registers ds.l    16
text            ds.b    256
