; The 68030's data cache. AmigaDOS leaves it as it found it; the 68020 has none.

        include "amiga.i"
        include "routine.i"

        mc68030

CACR_ENABLE_DATA        equ     $100
CACR_CLEAR_DATA         equ     $800
CACR_BURST_DATA         equ     $1000
CACR_ALLOCATE           equ     $2000   ; on writes, too

;==============================================================================
; cache_data - switches the data cache on or off
;
; in:      d0  int32  1 on, with bursts and write allocation; 0 off
; out:     d0  int32  1 if it is on now, 0 where there is none
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  CACR
; formats: -
; error:   -
; cost:    -
;==============================================================================
        routine cache_data,d0
        movem.l d2/a5-a6,-(sp)
        move.l  d0,d2
        lea     .supervisor(pc),a5
        movea.l sys_base,a6
        lvo     Supervisor
        move.l  d2,d0
        movem.l (sp)+,d2/a5-a6
        rts
.supervisor
        movec   cacr,d0
        and.l   #~(CACR_ENABLE_DATA|CACR_BURST_DATA|CACR_ALLOCATE),d0
        tst.l   d2
        beq.s   .set
        or.l    #CACR_ENABLE_DATA|CACR_CLEAR_DATA|CACR_BURST_DATA|CACR_ALLOCATE,d0
.set    movec   d0,cacr
        movec   cacr,d0
        moveq   #0,d2
        btst    #8,d0
        beq.s   .off
        moveq   #1,d2
.off    rte
