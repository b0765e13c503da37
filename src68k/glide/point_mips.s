        include "glide_mips.i"

; glide_point_mips - texels by point sampling, a level for each pixel
;
; in:      a0  const glide_coordinates*  coordinates of one level, without half a texel
;          a1  uint32*  texels, R G B A
;          a2  const glide_mips*  the pixels' LODs, the levels
; formats: s:t, both 12.4 modulo 2^16, no axis clamped; LODs 8.8, 0 to 8.0
        pass    glide_point_mips
        save_all
        lea     (a0,d0.l*4),a6
        movea.l glide_mips_lods(a2),a3
        movea.l glide_mips_levels(a2),a4
.pixels mip_open a3
        lsr.l   d5,d0
        swap    d5
        and.l   d2,d0
        moveq   #0,d2
        n64_index
        lsr.l   #2,d2
        move.l  (a2,d2.l),(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        return_all
