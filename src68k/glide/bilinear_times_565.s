        include "glide.i"

; glide_bilinear_times_565 - texels by the bilinear filter, times others, into a 16-bit frame
;
; like:    glide_bilinear_times
; in:      a1  uint16*  pixels, 5/6/5
; formats: s:t, both 12.4 modulo 2^16; the texels of glide_bilinear_times, each channel's upper bits

write_product_565 macro
        moveq   #0,d1
        swap    d2
        glide_product d2,d0             ; R
        swap    d3
        lsl.w   #8,d0
        glide_product d3,d1             ; G
        swap    d2
        and.w   #$f800,d0
        lsl.w   #3,d1
        glide_product d2,d0             ; B
        lsr.b   #3,d0
        and.w   #$07e0,d1
        addq.l  #1,a6
        or.w    d1,d0
        move.w  d0,(a1)+
        endm

        pass    glide_bilinear_times_565
        glide_filter_times write_product_565
