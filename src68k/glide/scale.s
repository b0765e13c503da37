        include "glide.i"

; glide_scale - texels times one factor for all channels
;
; like:    glide_modulate
; in:      a2  const glide_mix*  the factors; not the others
; formats: factor m, inverted by flip, + one: texel * m >> 8

; Also does local - local * factor: 256 - (m + 1) is m inverted, with 0 for one.

        pass    glide_scale
        save_all
        glide_mix_open
.pixels glide_factor d2
        move.l  (a0)+,d0
        move.l  d0,d3
        and.l   d7,d3                   ; -G-A
        eor.l   d3,d0
        lsr.l   #8,d0                   ; -R-B
        mulu.l  d2,d3
        mulu.l  d2,d0
        lsr.l   #8,d3
        glide_mix_close
