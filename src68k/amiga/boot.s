; boot - the code in a disk's first two sectors: starts dos, as any bootable disk does
;
; in:      a6  const struct ExecBase*  exec
;          a1  const struct IOStdReq*  the drive's, open
; out:     d0  int32  0: start the routine a0; -1: no dos
;          a0  void*  dos's initial routine
; reads:   exec's list of resident modules
; formats: after the sectors' header of 12 bytes; position-independent, no data elsewhere
        include "amiga.i"

        xdef    boot
        section .text.boot,code
boot:
        lea     .dos(pc),a1
        lvo     FindResident
        movea.l d0,a0
        tst.l   d0
        beq.s   .none
        movea.l rt_Init(a0),a0
        moveq   #0,d0
        rts
.none   moveq   #-1,d0
        rts
.dos    dc.b    'dos.library',0
        even
