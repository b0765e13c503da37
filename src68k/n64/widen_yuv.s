        include "routine.i"

; n64_widen_yuv - YUV texels that are not converted as inputs of the combiner
;
; in:      a0  const uint32*  texels, Y the last two bytes
;          a1  n64_wide*  U, V, Y, Y
;          a2  const n64_yuv_conversion*  chroma: U + 128, V + 128; the rest is not read
; formats: Y 0 to 255, U and V -128 to 127
        pass    n64_widen_yuv
        movem.l d2-d4/a2,-(sp)
        movea.l n64_yuv_conversion_chroma(a2),a2
        move.w  d0,d3
        subq.w  #1,d3
        moveq   #0,d0
        move.w  #128,d4
.pixels move.b  (a2),d0
        move.w  d0,d1
        sub.w   d4,d1
        swap    d1
        move.b  1(a2),d0
        move.w  d0,d1
        sub.w   d4,d1
        move.l  d1,(a1)+
        move.w  2(a0),d2
        addq.l  #4,a0
        addq.l  #4,a2
        move.w  d2,d1
        lsr.w   #8,d1
        swap    d1
        move.b  d2,d0
        move.w  d0,d1
        move.l  d1,(a1)+
        dbra    d3,.pixels
        movem.l (sp)+,d2-d4/a2
        rts
