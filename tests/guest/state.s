; The machine's state as a line of numbers; STATE of tests/helpers/endings.py has their names.

        include "amiga.i"
        include "routine.i"

        xref    _text_add
        xref    _text_number
        xref    _text_print

IDNestCnt               equ     294     ; followed by TDNestCnt
AFB_68030               equ     2
tc_SigAlloc             equ     18
VECTOR_LEVEL_3          equ     $6c
VECTOR_LEVEL_6          equ     $78

        routine state
        movem.l d2/d3/a2/a5/a6,-(sp)
        movea.l sys_base,a6
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a2
        move.l  #$7ffffff0,d0           ; fails, and so flushes unused memory
        moveq   #0,d1
        lvo     AllocMem
        moveq   #MEMF_CHIP,d1
        lvo     AvailMem
        bsr     number
        moveq   #MEMF_FAST,d1
        lvo     AvailMem
        bsr     number
        moveq   #0,d0
        move.w  custom+intenar,d0
        bsr     number
        moveq   #0,d0
        move.w  custom+dmaconr,d0
        and.w   #$7ff,d0                ; not the blitter's zero flag
        bsr     number
        move.l  VECTOR_LEVEL_6.w,d0
        bsr     number
        move.l  tc_TrapCode(a2),d0
        bsr     number
        moveq   #0,d0
        move.w  IDNestCnt(a6),d0
        bsr     number
        move.l  tc_SigAlloc(a2),d0
        bsr     number
        moveq   #0,d0
        moveq   #0,d1
        lvo     SetSignal
        and.l   #SIGBREAKF_CTRL_C,d0
        bsr     number
        lea     .ciab(pc),a1
        lvo     OpenResource
        movea.l d0,a6
        moveq   #ICRB_TA,d2
        bsr     timer
        moveq   #ICRB_TB,d2
        bsr     timer
        movea.l sys_base,a6
        moveq   #0,d0
        btst    #AFB_68030,AttnFlags+1(a6)
        beq.s   .no_cache
        lea     .read_cacr(pc),a5
        lvo     Supervisor
.no_cache
        bsr.s   number
        lea     .graphics(pc),a1
        moveq   #0,d0
        lvo     OpenLibrary
        movea.l d0,a1
        move.l  gb_ActiView(a1),d2
        lvo     CloseLibrary
        move.l  d2,d0
        bsr.s   number
        move.l  VECTOR_LEVEL_3.w,d0
        bsr.s   number
        bsr.s   field_lines
        bsr.s   number
        jsr     _text_print
        movem.l (sp)+,d2/d3/a2/a5/a6
        rts
.read_cacr
        mc68030
        movec   cacr,d0
        and.l   #$3313,d0               ; the enable bits, without the clear bits
        mc68020
        rte
.ciab   dc.b    'ciab.resource',0
.graphics
        dc.b    'graphics.library',0
        even

; The owner of timer d2 of the CIA a6: 0 if it is free.
timer:  lea     server,a1
        move.l  d2,d0
        lvo     AddICRVector
        move.l  d0,d3
        bne.s   .taken
        lea     server,a1
        move.l  d2,d0
        lvo     RemICRVector
.taken  move.l  d3,d0
        bra.s   number
nothing rts                             ; a timer may be due

number: move.l  a6,-(sp)
        move.l  d0,-(sp)
        jsr     _text_number
        pea     blank
        jsr     _text_add
        addq.l  #8,sp
        movea.l (sp)+,a6
        rts
blank   dc.b    ' ',0

        routine field_lines             ; d0 = the beam's highest line in some fields
        movem.l d2/d3,-(sp)
        moveq   #0,d0
        moveq   #0,d2
        moveq   #4-1,d1
.read   move.l  custom+vposr,d3
        lsr.l   #8,d3
        and.w   #$1ff,d3
        cmp.w   d0,d3
        bls.s   .lower
        move.w  d3,d0
.lower  exg     d2,d3
        cmp.w   d3,d2
        bhs.s   .read
        dbra    d1,.read
        movem.l (sp)+,d2/d3
        rts

        section .data.state,data
        cnop    0,4
server  dc.l    0,0                     ; struct Interrupt
        dc.b    2,0
        dc.l    blank,0,nothing
