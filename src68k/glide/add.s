        include "glide.i"

; glide_add - texels plus others
;
; like:    glide_modulate
; in:      a2  const glide_mix*  the others
; formats: the sum of each channel, 255 at most

; Bits 0 to 6 of all channels are added at once. Bit 7's sum carries if both have it set, or if one
; has and the lower bits carry into it.

        pass    glide_add
        movem.l d2-d7/a2-a3,-(sp)
        lea     (a0,d0.l*4),a3
        move.l  glide_mix_other_step(a2),d5
        movea.l glide_mix_other(a2),a2
        move.l  #$7f7f7f7f,d7
        move.l  #$80808080,d6
.pixels move.l  (a0)+,d0
        move.l  (a2),d1
        adda.l  d5,a2
        move.l  d0,d2
        move.l  d1,d3
        and.l   d7,d2
        and.l   d7,d3
        add.l   d3,d2                   ; of bits 0 to 6
        move.l  d0,d3
        eor.l   d1,d3
        and.l   d1,d0
        move.l  d2,d1
        and.l   d3,d1
        or.l    d1,d0
        and.l   d6,d3
        and.l   d6,d0                   ; beyond 255
        eor.l   d3,d2
        move.l  d0,d1
        lsr.l   #7,d1
        add.l   d0,d0
        sub.l   d1,d0                   ; 255 for each
        or.l    d2,d0
        glide_modulate_close
