        include "routine.i"

; n64_map_intensity - colours of intensities
;
; in:      a0  const uint32*  intensities, the last bytes
;          a1  uint32*  colours, R G B A; may be the same memory
;          a2  const uint32*  the colours of 256

        pass    n64_map_intensity
        movem.l d2-d3,-(sp)
        move.w  #255,d3
        move.w  d0,d2
        subq.w  #1,d2
.pixels move.l  (a0)+,d0
        and.w   d3,d0
        move.l  (a2,d0.w*4),(a1)+
        dbra    d2,.pixels
        movem.l (sp)+,d2-d3
        rts
