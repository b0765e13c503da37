; The 68030's data cache; the 68020 has none.

        include "amiga.i"

        xref    at_end

        mc68030

CACR_DATA               equ     $3f00   ; the data cache's bits
CACR_ENABLE_DATA        equ     $100
CACR_CLEAR_DATA         equ     $800
CACR_BURST_DATA         equ     $1000
CACR_ALLOCATE           equ     $2000   ; on writes, too

; cache_data - switches the data cache on; the program's end restores it
;
; out:     d0  int32  1 if it is on, 0 if there is none
; writes:  CACR; bursts and write allocation are on, too
; error:   call it once
        routine cache_data
        movem.l a5-a6,-(sp)
        lea     cache_end,a0
        jsr     at_end
        lea     .supervisor(pc),a5
        movea.l sys_base,a6
        lvo     Supervisor
        movem.l (sp)+,a5-a6
        moveq   #1,d0
        and.l   new_cacr,d0
        rts
.supervisor
        movec   cacr,d0
        move.l  d0,old_cacr
        and.l   #~CACR_DATA,d0
        or.l    #CACR_ENABLE_DATA|CACR_CLEAR_DATA|CACR_BURST_DATA|CACR_ALLOCATE,d0
        movec   d0,cacr
        movec   cacr,d0
        lsr.l   #8,d0                   ; CACR_ENABLE_DATA is bit 0
        move.l  d0,new_cacr
        rte

cache_leave:
        movem.l a5-a6,-(sp)
        lea     .supervisor(pc),a5
        movea.l sys_base,a6
        lvo     Supervisor
        movem.l (sp)+,a5-a6
        rts
.supervisor
        move.l  old_cacr,d0
        or.l    #CACR_CLEAR_DATA,d0
        movec   d0,cacr
        rte

        section .data.cache,data
cache_end       dc.l    0,cache_leave   ; struct end

        section .bss.cache,bss
old_cacr        ds.l    1
new_cacr        ds.l    1
