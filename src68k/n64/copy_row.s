        include "routine.i"

; n64_copy_row - copies a row of a page
;
; in:      a0  const uint32*  the row
;          a1  uint32*  the copy
;          d0  int32  longwords, a multiple of 32
        routine n64_copy_row,a0,a1,d0
        movem.l d2-d7/a2-a3,-(sp)
        lsr.l   #5,d0
        subq.l  #1,d0
.longs
offset  set     0
        rept    4
        movem.l (a0)+,d1-d7/a2
        movem.l d1-d7/a2,offset(a1)
offset  set     offset+32
        endr
        lea     128(a1),a1
        dbra    d0,.longs
        movem.l (sp)+,d2-d7/a2-a3
        rts
