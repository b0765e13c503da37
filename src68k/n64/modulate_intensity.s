        include "routine.i"

; n64_modulate_intensity - colours of the products of intensities
;
; in:      a0  const uint32*  intensities, the last bytes
;          a1  uint32*  colours, R G B A; may be the same memory
;          a2  const n64_intensities*  the other intensities, the colours
; formats: of each product + 128 >> 8

        pass    n64_modulate_intensity
        movem.l d2-d4/a2-a3,-(sp)
        movea.l n64_intensities_other(a2),a3
        movea.l n64_intensities_colours(a2),a2
        move.w  #255,d3
        move.w  #128,d4
        move.w  d0,d2
        subq.w  #1,d2
.pixels move.l  (a0)+,d0
        move.l  (a3)+,d1
        and.w   d3,d0
        and.w   d3,d1
        mulu.w  d1,d0
        add.w   d4,d0
        lsr.w   #8,d0
        move.l  (a2,d0.w*4),(a1)+
        dbra    d2,.pixels
        movem.l (sp)+,d2-d4/a2-a3
        rts
