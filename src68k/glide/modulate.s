        include "glide.i"

; glide_modulate - texels times others, channel by channel
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint32*  texels; may be the same memory
;          a2  const glide_mix*  the others; flip
; formats: m = other, inverted by flip: texel * (m + 1) >> 8
        pass    glide_modulate
        glide_modulate_open
        glide_products
        swap    d0
        swap    d1
        glide_products
        swap    d0
        glide_modulate_close
