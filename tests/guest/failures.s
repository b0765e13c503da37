; failures - fails in a way chosen by number; tests/guest/test_emulator.py has the names.
;
; failures N

        include "amiga.i"
        include "routine.i"
        xref    args_read
        xref    file_open
        xref    mem_alloc
        xref    clock_open
        xref    quiet_enter
        xref    clock_start
        xref    _text_add
        xref    _text_number
        xref    _text_print

        routine main
        move.l  #template,d0
        move.l  #items,d1
        jsr     args_read
        movea.l items,a0
        move.l  (a0),d0
        jmp     ([table,d0.l*4])

        routine illegal_one             ; with recognisable values in registers
        move.l  #$12345678,d3
        movea.l #$9abcdef0,a4
        illegal

        routine zero_divide
        moveq   #0,d0
        divu.w  d0,d1
        rts

        routine odd_jump                ; to an illegal instruction, should odd PCs work
        jmp     odd_place+1
odd_place
        dc.b    $4e,$4a,$fc,$71
        rts

        routine privileged
        move.w  #0,sr
        rts

        routine trap_five
        trap    #5
        rts

        routine line_f
        dc.w    $f123
        rts

        routine jump_away               ; into the data, which begins with line A
        jmp     away

        routine quiet_illegal
        bsr.s   all_of_it
        illegal

        routine quiet_loop
        bsr.s   all_of_it
.loop   bra.s   .loop

all_of_it                               ; open file, memory, timers, quiet mode, watchdog
        move.l  #kept,d0
        move.l  #1006,d1
        jsr     file_open
        move.l  d0,-(sp)
        jsr     _text_number
        addq.l  #4,sp
        jsr     _text_print
        move.l  #items,d0
        move.l  #100000,d1
        movea.w #2,a0
        jsr     mem_alloc
        jsr     clock_open
        jsr     quiet_enter
        moveq   #2,d0
        jmp     clock_start

        routine loud_loop
        bsr.s   say
.loop   bra.s   .loop

        routine reboot
        bsr.s   say
        movea.l sys_base,a6
        jmp     -726(a6)                ; ColdReboot

say     pea     words
        jsr     _text_add
        addq.l  #4,sp
        jmp     _text_print

        section .data.failures,data
        cnop    0,4
away    dc.w    $a000,$a000
table   dc.l    illegal_one,zero_divide,odd_jump,privileged,trap_five,line_f,jump_away
        dc.l    quiet_illegal,quiet_loop,loud_loop,reboot
template dc.b   'N/A/N',0
words   dc.b    'this far',0
kept    dc.b    'kept',0
        section .bss.failures,bss
items   ds.l    1
