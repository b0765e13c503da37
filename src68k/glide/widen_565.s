        include "routine.i"

; glide_widen_565 - a 16-bit frame's pixels as texels
;
; in:      a0  const uint16*  pixels, 5/6/5
;          a1  uint32*  texels, R G B and 0
;          a2  void*  not read
; formats: each channel's upper bits are repeated below its bits

; Two pixels at a time, by aligned longwords.

; Widens the pixels in d0: the upper one's texel to d0, the other's to d1. Uses d2-d3.
wide    macro
        move.l  d0,d1
        move.l  d0,d2
        and.l   d7,d0                   ; R of both
        ror.l   #5,d1
        and.l   d7,d1                   ; B, the other way round
        move.l  d0,d3
        lsr.l   #5,d3
        and.l   d6,d3
        or.l    d3,d0
        move.l  d1,d3
        lsr.l   #5,d3
        and.l   d6,d3
        or.l    d3,d1
        lsr.l   #3,d2
        and.l   d5,d2
        or.l    d2,d0
        lsr.l   #6,d2
        and.l   d4,d2
        or.l    d2,d0                   ; RGRG
        move.w  d0,d3
        move.w  d1,d0                   ; RGB- of the upper one
        move.w  d3,d1
        swap    d1
        endm

        pass    glide_widen_565
        movem.l d2-d7/a2-a3,-(sp)
        movea.l d0,a2
        move.l  #$00030003,d4
        move.l  #$00fc00fc,d5
        move.l  #$07000700,d6
        move.l  #$f800f800,d7
        move.w  a0,d1
        btst    #1,d1
        beq.s   .aligned
        move.w  (a0)+,d0
        swap    d0
        wide
        move.l  d0,(a1)+
        subq.l  #1,a2
.aligned
        move.l  a2,d0
        lsr.l   #1,d0
        beq.s   .last
        lea     (a0,d0.l*4),a3
.pairs  move.l  (a0)+,d0
        wide
        move.l  d0,(a1)+
        move.l  d1,(a1)+
        cmpa.l  a3,a0
        bne.s   .pairs
.last   move.w  a2,d0
        lsr.w   #1,d0
        bcc.s   .done
        move.w  (a0)+,d0
        swap    d0
        wide
        move.l  d0,(a1)+
.done   movem.l (sp)+,d2-d7/a2-a3
        rts
