; Quiet mode, in which the program has the machine to itself: no DMA, and no interrupt except the
; watchdog, which ends a routine that never returns. It uses CIA-B's timers, as the clock does.

        include "amiga.i"

        xdef    quiet_leave,quiet
        xref    ciab_base,fault_number,fault_enter

FAULT_WATCHDOG          equ     $100    ; no CPU exception has this number
VECTOR_LEVEL_6          equ     $78

; quiet_enter - switches DMA and interrupts off, except the watchdog
;
; writes:  DMACON, INTENA, the level 6 vector: quiet_leave restores them
; error:   calls do not nest; clock_open must have succeeded
        routine quiet_enter
        movem.l a5/a6,-(sp)
        movea.l sys_base,a6
        lvo     Disable
        lea     custom,a0
        move.w  intenar(a0),old_intena
        move.w  dmaconr(a0),old_dmacon
        move.w  #$7fff,intena(a0)
        move.w  #$7fff,dmacon(a0)
        lea     install_watchdog(pc),a5
        lvo     Supervisor
        movea.l ciab_base,a6
        moveq   #ICRF_ALL,d0
        lvo     AbleICR
        move.l  d0,old_icr
        move.b  ciab+ciaicr,old_flags   ; reading clears them
        move.b  #ICRF_SETCLR|ICRF_TB,ciab+ciaicr
        lea     custom,a0
        move.w  #INTF_SETCLR|INTF_INTEN|INTF_EXTER,intena(a0)
        st      quiet
        movem.l (sp)+,a5/a6
        rts

install_watchdog:                       ; in supervisor mode
        movec   vbr,a0
        move.l  VECTOR_LEVEL_6(a0),old_level_6
        move.l  #watchdog,VECTOR_LEVEL_6(a0)
        rte

remove_watchdog:
        movec   vbr,a0
        move.l  old_level_6,VECTOR_LEVEL_6(a0)
        rte

; Level 6 has sources other than CIA-B. An interrupt of theirs stays pending until
; quiet_leave: level 6 is masked, and the watchdog with it.
watchdog:
        move.b  ciab+ciaicr,flags
        btst    #ICRB_TB,flags
        bne.s   .bite
        move.w  #INTF_EXTER,custom+intena
        rte
.bite   move.l  #FAULT_WATCHDOG,fault_number
        move.w  #INTF_INTEN,custom+intena
        jmp     fault_enter

; quiet_leave - restores what quiet_enter changed
;
; writes:  DMACON, INTENA, the level 6 vector
; error:   does nothing outside quiet mode
        routine quiet_leave
        movem.l a5/a6,-(sp)
        tst.b   quiet
        beq     .done
        sf      quiet
        lea     custom,a0
        move.w  #$7fff,intena(a0)
        move.b  #CRAF_STOP,ciab+ciacra
        move.b  #CRBF_STOP,ciab+ciacrb
        move.b  #ICRF_ALL,ciab+ciaicr
        tst.b   ciab+ciaicr
        movea.l sys_base,a6
        lea     remove_watchdog(pc),a5
        lvo     Supervisor
        movea.l ciab_base,a6
        move.l  old_icr,d0
        or.l    #ICRF_SETCLR,d0
        lvo     AbleICR
        moveq   #ICRF_OTHERS,d0         ; makes them pending again
        and.b   old_flags,d0
        beq.s   .none_pending
        or.w    #ICRF_SETCLR,d0
        lvo     SetICR
.none_pending
        lea     custom,a0
        move.w  old_dmacon,d0
        or.w    #INTF_SETCLR,d0
        move.w  d0,dmacon(a0)
        move.w  old_intena,d0
        or.w    #INTF_SETCLR,d0
        move.w  d0,intena(a0)
        movea.l sys_base,a6
        lvo     Enable
.done   movem.l (sp)+,a5/a6
        rts

        section .bss.quiet,bss
old_icr         ds.l    1
old_level_6     ds.l    1
old_intena      ds.w    1
old_dmacon      ds.w    1
quiet           ds.b    1
old_flags       ds.b    1
flags           ds.b    1
