        include "routine.i"

; n64_map - texels through a table for each channel
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint32*  texels; may be the same memory
;          a2  const uint8*  256 bytes for each of R, G, B, A

; Replaces a combiner whose only input, apart from constants, is the texel.

        pass    n64_map
        movem.l d2-d3/a2-a6,-(sp)
        lea     (a0,d0.l*4),a6
        lea     256(a2),a3
        lea     512(a2),a4
        lea     768(a2),a5
        moveq   #0,d1
        moveq   #0,d2
        moveq   #0,d3
.pixels move.l  (a0)+,d0
        move.b  d0,d1                   ; A
        move.w  d0,d2
        lsr.w   #8,d2                   ; B
        move.b  (a5,d1.w),d1
        move.b  (a4,d2.w),d3
        swap    d0
        lsl.w   #8,d3
        move.b  d1,d3
        move.b  d0,d1                   ; G
        lsr.w   #8,d0                   ; R
        move.b  (a3,d1.w),d1
        move.b  (a2,d0.w),d2
        lsl.w   #8,d2
        move.b  d1,d2
        swap    d2
        move.w  d3,d2
        move.l  d2,(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        movem.l (sp)+,d2-d3/a2-a6
        rts
