        include "glide.i"

; glide_lerp - linear interpolation to others: between levels, the combine unit's blend
;
; like:    glide_modulate
; in:      a2  const glide_mix*  the others, the factors
; formats: factor m, inverted by flip, + one: texel + ((other - texel) * m >> 8)

; Two channels in one product: neither overflows its word.

        pass    glide_lerp
        save_all
        glide_mix_open
.pixels glide_factor d2
        move.l  (a0)+,d0
        move.l  (a3),d1
        adda.l  d6,a3
        move.l  d0,d3
        move.l  d1,d4
        and.l   d7,d3                   ; -G-A
        and.l   d7,d4
        sub.l   d3,d4
        eor.l   d3,d0                   ; R-B-, 256 of each
        muls.l  d2,d4
        n64_between
        lsr.l   #8,d3
        add.l   d1,d0
        glide_mix_close
