        include "n64.i"

; glide_point - texels by point sampling
;
; like:    glide_bilinear
; in:      a2  const glide_decoded*  the level
; formats: s:t, both 12.4 modulo 2^16
        pass    glide_point
        n64_texels glide_decoded,2,d2.l
