        include "n64.i"

; glide_flips - factors of levels of detail whose odd levels invert them
;
; in:      a0  const uint16*  LODs
;          a1  uint8*  factors
;          a2  void*  not read
; formats: LODs 8.8; the fraction, its bits inverted if the integer is odd
        pass    glide_flips
        movem.l d6-d7/a3,-(sp)
        n64_rounds
        lsl.l   #2,d6
        lea     .pixels(pc,d6.l),a3
        adda.l  d6,a3
        adda.l  d6,a3
        jmp     (a3)
.pixels rept    8
        move.w  (a0)+,d0                ; 12 bytes
        move.w  d0,d1
        lsl.w   #8,d1                   ; X is the integer's lowest bit
        subx.b  d1,d1
        eor.b   d1,d0
        move.b  d0,(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d6-d7/a3
        rts
