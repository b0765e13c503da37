        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tx_walk - coordinates without perspective
;
; in:      a0  const tx_iterators*  s and t at the first pixel
;          a1  tx_coordinates*  coordinates
;          a2  const tx_iterators*  what they change by
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   s and t
; writes:  the coordinates
; formats: s15.16 modulo 2^32 to s:t, the upper words
; error:   none
; cost:    bench row tx_walk
;==============================================================================
        routine tx_walk,a0,a1,a2,d0
        movem.l d2-d7,-(sp)
        tx_rounds
        movem.l (a0),d0-d1
        movem.l (a2),d2-d3
        tx_step
        movem.l (sp)+,d2-d7
        rts
