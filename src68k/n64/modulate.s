        include "routine.i"

; n64_modulate - texels times other colours
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint32*  texels; may be the same memory
;          a2  const n64_modulation*  the other colours
; formats: texel * other + 128 >> 8, each channel: needs no clamping

; Multiplies each byte x of d0's lower word by the same byte y of d1: \1's lower word =
; (x y + 128) >> 8 of both. d6 is 128. Uses d3-d4.
products macro
        moveq   #0,d3
        moveq   #0,d4
        move.b  d0,d3
        move.b  d1,d4
        mulu.w  d4,d3
        move.w  d0,\1
        move.w  d1,d4
        lsr.w   #8,\1
        lsr.w   #8,d4
        mulu.w  d4,\1
        add.w   d6,d3
        add.w   d6,\1
        lsr.w   #8,d3
        move.b  d3,\1
        endm

        pass    n64_modulate
        movem.l d2-d7/a2-a3,-(sp)
        lea     (a0,d0.l*4),a3
        move.l  n64_modulation_step(a2),d7
        movea.l n64_modulation_other(a2),a2
        move.w  #128,d6
.pixels move.l  (a0)+,d0
        move.l  (a2),d1
        adda.l  d7,a2
        products d2
        swap    d0
        swap    d1
        products d5
        swap    d5
        move.w  d2,d5
        move.l  d5,(a1)+
        cmpa.l  a3,a0
        bne.s   .pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
