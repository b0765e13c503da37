; Interrupts a program at regular intervals while its frames are timed, and counts the places that it has
; reached, so that the tools know where its time goes. Linked in for that run only.

        include "amiga.i"

        xref    _main,_file_save,clock_start,clock_stop,start

PROFILE_WORDS           equ     147456  ; of code: 288 KB
PROFILE_PERIOD          equ     101     ; E-clocks: 2,020 cycles; a prime, so that no loop keeps step
VECTOR_LEVEL_2          equ     $68

; profile_main - runs main and writes the file profile.counts
;
; out:     d0  int32  what main returns
; formats: a long for each word of the code from `start` on: how often the next instruction was there
; error:   code after the first 256 KB is not counted; an interrupt waits for the end of an instruction, and
;          takes some 40 bytes of the instruction cache
; cost:    some 200 cycles a count
        routine profile_main
        jsr     _main
        move.l  d0,-(sp)
        move.l  #PROFILE_WORDS*4,-(sp)
        pea     profile_counts
        pea     .name(pc)
        jsr     _file_save
        lea     12(sp),sp
        move.l  (sp)+,d0
        rts
.name   dc.b    'profile.counts',0
        even

; profile_start - replaces clock_start; begins to count as well
;
; in:      d0  int32  limit before the watchdog bites, in 65,536 E-clocks
; reads:   the beam's position
; writes:  CIA-B timers A and B, CIA-A timer B, INTENA, the level 2 vector
; error:   only in quiet mode, which has switched all interrupts off; those of CIA-A stay off, so the machine is fit
;          for no more than writing files
        routine profile_start,d0
        movem.l d0/a5/a6,-(sp)
        movea.l sys_base,a6
        lea     .vector(pc),a5
        lvo     Supervisor
        lea     ciaa,a0
        move.b  #ICRF_ALL,ciaicr(a0)
        move.b  #PROFILE_PERIOD,ciatblo(a0)
        clr.b   ciatbhi(a0)
        tst.b   ciaicr(a0)
        move.b  #ICRF_SETCLR|ICRF_TB,ciaicr(a0)
        move.b  #CRBF_COUNT_E,ciacrb(a0)
        move.w  #INTF_PORTS,custom+intreq
        move.w  #INTF_SETCLR|INTF_PORTS,custom+intena
        movem.l (sp)+,d0/a5/a6
        jmp     clock_start
.vector movec   vbr,a0
        move.l  VECTOR_LEVEL_2(a0),old_level_2
        move.l  #profile_count,VECTOR_LEVEL_2(a0)
        rte

; profile_stop - replaces clock_stop; ends counting as well
;
; out:     d0  uint32  colour clocks since profile_start, with those of counting
; reads:   CIA-B timers A and B, the beam's position
; writes:  CIA-A timer B, INTENA, the level 2 vector
        routine profile_stop
        movem.l a5/a6,-(sp)
        move.w  #INTF_PORTS,custom+intena
        move.b  #CRBF_STOP,ciaa+ciacrb
        move.b  #ICRF_ALL,ciaa+ciaicr
        tst.b   ciaa+ciaicr
        move.w  #INTF_PORTS,custom+intreq
        movea.l sys_base,a6
        lea     .vector(pc),a5
        lvo     Supervisor
        movem.l (sp)+,a5/a6
        jmp     clock_stop
.vector movec   vbr,a0
        move.l  old_level_2,VECTOR_LEVEL_2(a0)
        rte

profile_count:                          ; the stacked PC: the next instruction
        movem.l d0/a0,-(sp)
        tst.b   ciaa+ciaicr             ; reading clears its flags
        move.w  #INTF_PORTS,custom+intreq
        move.l  8+2(sp),d0
        sub.l   #start,d0
        lsr.l   #1,d0
        cmp.l   #PROFILE_WORDS,d0
        bcc.s   .done
        lea     profile_counts,a0
        addq.l  #1,(a0,d0.l*4)
.done   movem.l (sp)+,d0/a0
        rte

        section .bss.profile,bss
old_level_2     ds.l    1
profile_counts  ds.l    PROFILE_WORDS
