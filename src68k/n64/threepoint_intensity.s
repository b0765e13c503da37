        include "n64.i"

; n64_threepoint_intensity - intensities, the same in all channels, by the three-point filter
;
; like:    n64_threepoint
; in:      a1  uint32*  intensities, 0 to 255
        xref    n64_weights_ga_table

        pass    n64_threepoint_intensity
        save_all
        lea     (a0,d0.l*4),a6
        move.l  n64_decoded_mask_s(a2),d6       ; and mask_t
        move.w  n64_decoded_columns_bits(a2),d5
        movea.l n64_decoded_quads(a2),a4
        move.l  #$001f001f,d4
        lea     n64_weights_ga_table,a5
        lea     .weighed(pc),a3
        move.l  #255,d7
.pixels move.l  (a0)+,d0                ; s:t
        n64_quad_find
        move.l  (a5,d1.w*4),d1
        adda.w  d1,a2
        swap    d1
        jmp     (a5,d1.w)
.weighed
        lsr.w   #8,d3
        and.l   d7,d3
        move.l  d3,(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        return_all
