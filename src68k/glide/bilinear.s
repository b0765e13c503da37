        include "glide.i"

; glide_bilinear - texels by the bilinear filter
;
; in:      a0  const glide_coordinates*  coordinates
;          a1  uint32*  texels, R G B A
;          a2  const glide_decoded*  the level, with quads
; formats: s:t, both 12.4 modulo 2^16; weights of 1/256, the sum cut to 8 bits
        pass    glide_bilinear
        glide_filter n64_write,$00ff00ff
