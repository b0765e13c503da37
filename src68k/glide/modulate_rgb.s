        include "glide.i"

; glide_modulate_rgb - texels times others, channel by channel, except alpha
;
; like:    glide_modulate
; formats: m = other, inverted by flip: texel * (m + 1) >> 8; A is the texel's
        pass    glide_modulate_rgb
        glide_modulate_open
        move.w  d0,d2
        move.w  d1,d3
        lsr.w   #8,d2
        lsr.w   #8,d3
        addq.w  #1,d3
        mulu.w  d3,d2
        move.b  d0,d2
        move.w  d2,d0
        swap    d0
        swap    d1
        glide_products
        swap    d0
        glide_modulate_close
