        include "glide.i"

; glide_bilinear_565 - texels by the bilinear filter into a 16-bit frame
;
; like:    glide_bilinear
; in:      a1  uint16*  pixels, 5/6/5
; formats: s:t, both 12.4 modulo 2^16; the texels of glide_bilinear, each channel's upper bits

; Writes the texel d2, R-B-, and d3, G-A-.
write_565 macro
        lsr.l   #5,d3
        eor.l   d2,d3
        and.l   d7,d3                   ; 07e00000
        eor.l   d3,d2                   ; RG, B-
        move.w  d2,d3
        swap    d2
        lsr.w   #8,d3
        and.w   #$ffe0,d2
        lsr.w   #3,d3
        or.w    d3,d2
        move.w  d2,(a1)+
        endm

        pass    glide_bilinear_565
        glide_filter write_565,$07e00000
