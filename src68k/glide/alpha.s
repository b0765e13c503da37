        include "n64.i"

; glide_alpha - replaces the texels' alpha, and inverts channels
;
; like:    glide_modulate
; in:      a2  const glide_alphas*  the alphas, the bits to invert
; formats: R G B of the texels, A a byte of the alphas; then bits inverted
        pass    glide_alpha
        movem.l d2-d7/a2-a3,-(sp)
        n64_rounds
        movem.l glide_alphas_step(a2),d4-d5     ; and inverted
        movea.l glide_alphas_alphas(a2),a2
        lea     .pixels(pc,d6.l*2),a3
        jmp     (a3,d6.l*8)
.pixels rept    8
        move.l  (a0)+,d0                ; 10 bytes
        move.b  (a2),d0
        adda.l  d4,a2
        eor.l   d5,d0
        move.l  d0,(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
