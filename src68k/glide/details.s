        include "n64.i"

; glide_details - detail factors of levels of detail
;
; in:      a0  const uint16*  LODs
;          a1  uint8*  factors
;          a2  const glide_nearness*  the LOD where they end, their growth
; formats: LODs 8.8, none above end, none so far below it that the factor exceeds a byte; factor =
;          end - LOD, shifted right
        pass    glide_details
        movem.l d2-d3/d6-d7/a2,-(sp)
        n64_rounds
        move.w  glide_nearness_end(a2),d2
        move.w  glide_nearness_shift(a2),d3
        lea     .pixels(pc,d6.l*8),a2
        jmp     (a2)
.pixels rept    8
        move.w  d2,d0                   ; 8 bytes
        sub.w   (a0)+,d0
        lsr.w   d3,d0
        move.b  d0,(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d3/d6-d7/a2
        rts
