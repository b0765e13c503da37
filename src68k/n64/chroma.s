        include "routine.i"

; n64_chroma - turns relative coordinates of YUV's luma into those of its chroma
;
; in:      a0  const n64_coordinates*  relative coordinates
;          a1  n64_coordinates*  those of chroma; may be the same memory
;          a2  void*  not read
; formats: s:t, both s10.5. A pair of texels shares its chroma: the fraction of s is halved,
;          plus another half in odd columns
        pass    n64_chroma
        movem.l d2-d3,-(sp)
        move.l  #$001f0000,d2
        move.w  d0,d3
        subq.w  #1,d3
.pixels move.l  (a0)+,d0
        move.l  d0,d1
        lsr.l   #1,d1
        eor.l   d0,d1
        and.l   d2,d1
        eor.l   d1,d0
        move.l  d0,(a1)+
        dbra    d3,.pixels
        movem.l (sp)+,d2-d3
        rts
