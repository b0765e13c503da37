        include "routine.i"

; n64_map - texels through a table, each channel by itself
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint32*  texels; may be the same memory
;          a2  const uint32*  256 R G B A

; Replaces a combiner whose only input, apart from constants, is the texel.

        pass    n64_map
        movem.l d2-d3/a3,-(sp)
        lea     (a0,d0.l*4),a3
        moveq   #0,d1
        moveq   #0,d2
        moveq   #0,d3
.pixels move.l  (a0)+,d0
        move.b  d0,d1                   ; A
        move.w  d0,d2
        lsr.w   #8,d2                   ; B
        move.b  3(a2,d1.w*4),d1
        move.b  2(a2,d2.w*4),d3
        swap    d0
        lsl.w   #8,d3
        move.b  d1,d3
        move.b  d0,d1                   ; G
        lsr.w   #8,d0                   ; R
        move.b  1(a2,d1.w*4),d1
        move.b  (a2,d0.w*4),d2
        lsl.w   #8,d2
        move.b  d1,d2
        swap    d2
        move.w  d3,d2
        move.l  d2,(a1)+
        cmpa.l  a3,a0
        bne.s   .pixels
        movem.l (sp)+,d2-d3/a3
        rts
