        include "glide.i"

; glide_bilinear_times - texels by the bilinear filter, times others, channel by channel
;
; like:    glide_bilinear
; in:      a2  const glide_times*  the level, with quads; the others, the table of products
; formats: s:t, both 12.4 modulo 2^16; m, weights of 1/256, the sum cut to 8 bits: other * (m + 1)
;          >> 8

; d2 = R-B- and d3 = G-A-: each word is a channel's index in the table but for the other's byte.
write_product macro
        swap    d2
        glide_product d2,d0             ; R
        swap    d3
        lsl.w   #8,d0
        glide_product d3,d0             ; G
        swap    d2
        swap    d0
        glide_product d2,d0             ; B
        swap    d3
        lsl.w   #8,d0
        glide_product d3,d0             ; A
        move.l  d0,(a1)+
        endm

        pass    glide_bilinear_times
        glide_filter_times write_product
