        include "n64.i"

; n64_threepoint_levels - texels by the three-point filter, of the tiles that levels choose
;
; in:      a0  const n64_coordinates*  coordinates
;          a1  uint32*  texels, R G B A
;          a2  const n64_level_sampling*  the pixels' blendings, the tiles with quads
; reads:   the coordinates, the tiles; the blendings, and N64_NO_TILES behind the last
; writes:  the texels, except those that are skipped
; formats: s:t, both s10.5 modulo 2^16, before the tile's shift

; A run of pixels has the same two tiles.

        pass    n64_threepoint_levels
        xref    n64_weights_table
        save_all
        move.l  a2,-(sp)
        subq.l  #4,sp                   ; the tile's fractions
        movea.l n64_level_sampling_blendings(a2),a6
        lea     n64_weights_table,a5
        lea     .weighed(pc),a3
        bra.s   .run

.skip   addq.l  #4,a0
        addq.l  #4,a1
        addq.l  #4,a6
        cmp.w   (a6),d7
        beq.s   .skip
.run    move.w  (a6),d7
        cmp.w   #N64_NO_TILES,d7
        beq.s   .done
        movea.l 4(sp),a2
        move.w  d7,d0
        lsr.w   #8,d0
        tst.w   n64_level_sampling_second(a2)
        beq.s   .tile
        cmp.b   d0,d7
        bne.s   .unlike
        tst.w   n64_level_sampling_skips(a2)
        bne.s   .skip
.unlike moveq   #0,d0
        move.b  d7,d0
.tile   movea.l n64_level_sampling_quads(a2),a4
        movea.l n64_level_sampling_tiles(a2),a2
        lsl.w   #4,d0
        adda.w  d0,a2
        adda.l  n64_level_tile_quads_at(a2),a4
        move.l  n64_level_tile_mask_s(a2),d6    ; and mask_t
        move.l  n64_level_tile_fractions(a2),(sp)
        move.w  n64_level_tile_columns_bits(a2),d5
        move.w  n64_level_tile_shift(a2),d4
        bra.s   .coordinates

.weighed
        lsr.l   #8,d3                   ; -G-A
        eor.l   d2,d3
        and.l   #$00ff00ff,d3
        eor.l   d3,d2
        move.l  d2,(a1)+
        addq.l  #4,a6
        cmp.w   (a6),d7
        bne.s   .run
.coordinates
        move.l  (a0)+,d0                ; s:t
        moveq   #0,d2
        lsr.l   d4,d0
        move.l  d0,d1
        and.l   d6,d0
        and.l   (sp),d1
        n64_index
        move.l  d1,d3
        lsr.l   #8,d3
        lsr.l   #3,d3
        or.w    d3,d1                   ; fs << 5 | ft
        move.w  (a5,d1.w*2),d1
        lea     (a4,d2.l*2),a2
        jmp     (a5,d1.w)
.done   addq.l  #8,sp
        return_all
