; Facts about the machine, and dos's texts for errors.

        include "amiga.i"

        xref    dos_base

AGNUS_BITS              equ     $7f

; machine_read - reads facts about the machine from exec and Agnus
;
; in:      a0  struct machine*  the struct to fill in
; reads:   ExecBase, VPOSR
; formats: see its fields
        routine machine_read,a0
        movem.l a2/a6,-(sp)
        movea.l a0,a2
        movea.l sys_base,a6
        moveq   #0,d0
        move.w  lib_Version(a6),d0
        move.l  d0,machine_exec_version(a2)
        move.w  lib_Revision(a6),d0
        move.l  d0,machine_exec_revision(a2)
        moveq   #0,d0
        move.b  AttnFlags+1(a6),d0
        move.l  d0,machine_attention(a2)
        move.l  ex_EClockFrequency(a6),machine_e_clock(a2)
        move.l  #MEMF_CHIP|MEMF_TOTAL,d1
        lvo     AvailMem
        move.l  d0,machine_chip(a2)
        bsr.s   fast_bytes
        move.l  d0,machine_fast(a2)
        moveq   #AGNUS_BITS,d0
        and.b   custom+vposr,d0
        move.l  d0,machine_agnus(a2)
        movem.l (sp)+,a2/a6
        rts

; d0 = bytes of fast RAM before chip RAM in exec's memory list, which is sorted by priority. Fast
; RAM after chip RAM is reserved by a Kickstart for itself.
fast_bytes
        lvo     Forbid
        moveq   #0,d0
        movea.l MemList(a6),a0
        bra.s   .test
.memory btst    #MEMB_CHIP,mh_Attributes+1(a0)
        bne.s   .done
        btst    #MEMB_FAST,mh_Attributes+1(a0)
        beq.s   .next
        add.l   mh_Upper(a0),d0
        sub.l   mh_Lower(a0),d0
.next   movea.l (a0),a0
.test   tst.l   (a0)                    ; its successor: the last one's is 0
        bne.s   .memory
.done   jmp     _LVOPermit(a6)          ; keeps all registers

; memory_is_chip - checks if an address is in chip RAM
;
; in:      a0  const void*  the address
; out:     d0  int32        1 if it is, 0 if not
        routine memory_is_chip,a0
        move.l  a6,-(sp)
        movea.l a0,a1
        movea.l sys_base,a6
        lvo     TypeOfMem
        movea.l (sp)+,a6
        and.l   #MEMF_CHIP,d0
        beq.s   .done
        moveq   #1,d0
.done   rts

; dos_fault - dos's text for the failure of its last call
;
; in:      d0  char*  where the text goes, zero-terminated
;          d1  int32  its size in bytes
; error:   a number that dos does not know is written as a number
        routine dos_fault,d0,d1
        movem.l d2-d4/a6,-(sp)
        move.l  d0,d3
        move.l  d1,d4
        movea.l dos_base,a6
        lvo     IoErr
        move.l  d0,d1
        moveq   #0,d2                   ; nothing before it
        lvo     Fault
        movem.l (sp)+,d2-d4/a6
        rts

; dos_requests - sets the window of dos's requesters
;
; in:      d0  int32  the window's address; 0 on Workbench's screen, -1 nowhere: calls just fail
; out:     d0  int32  the previous value
; writes:  the process's pr_WindowPtr, which is the shell's too: put the old one back
        routine dos_requests,d0
        movem.l d2/a6,-(sp)
        move.l  d0,d2
        suba.l  a1,a1
        movea.l sys_base,a6
        lvo     FindTask
        movea.l d0,a0
        move.l  pr_WindowPtr(a0),d0
        move.l  d2,pr_WindowPtr(a0)
        movem.l (sp)+,d2/a6
        rts
