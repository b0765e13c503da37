        include "glide_mips.i"

; glide_bilinear_mips - texels by the bilinear filter, a level for each pixel
;
; like:    glide_point_mips
; in:      a2  const glide_mips*  the pixels' LODs, the levels, with quads
; formats: s:t, both 12.4 modulo 2^16, no axis clamped; LODs 8.8, 0 to 8.0; weights of 1/256, the
;          sum cut to 8 bits

; Half a texel behind a shift by n is 2^(n + 3) before it, so (s >> n) - 8 is s - 2^(n + 3) >> n.

        xref    glide_weights_table

        pass    glide_bilinear_mips
        save_all
        move.l  d0,d6
        lsl.l   #2,d6
        add.l   a0,d6                   ; end
        movea.l glide_mips_lods(a2),a6
        movea.l glide_mips_levels(a2),a4
        move.l  #$00ff00ff,d7
        move.l  #$000f000f,d4
        lea     glide_weights_table,a5
        lea     .weighed(pc),a3
        bra.s   .coordinates
.weighed
        n64_write
        cmpa.l  d6,a0
        beq.s   .done
.coordinates
        mip_open a6
        or.w    #$8000,d0               ; so that t does not borrow
        sub.l   d1,d0
        lsr.l   d5,d0
        swap    d5
        move.l  d0,d1
        and.l   d2,d0
        and.l   d4,d1
        moveq   #0,d2
        n64_index
        move.l  d1,d3
        lsr.l   #8,d3
        lsr.l   #4,d3
        or.w    d3,d1                   ; fs << 4 | ft
        move.w  (a5,d1.w*2),d1
        lea     (a2,d2.l*2),a2
        jmp     (a5,d1.w)
.done   return_all
