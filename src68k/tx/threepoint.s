        include "routine.i"
        include "layout.i"
        include "tx.i"

        xref    tx_weights,tx_weights_table

;==============================================================================
; tx_threepoint - texels by the three-point filter
;
; in:      a0  const tx_coordinates*  relative coordinates
;          a1  uint32*  texels, R G B A
;          a2  const tx_decoded*  the tile, with quads
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the coordinates, the tile, its quads
; writes:  the texels
; formats: s:t, both s10.5 modulo 2^16
; error:   none
; cost:    bench row tx_threepoint
;==============================================================================
        routine tx_threepoint,a0,a1,a2,d0
        save_all
        lea     (a0,d0.l*4),a3
        move.l  a3,-(sp)
        move.l  tx_decoded_mask_s(a2),d6        ; and mask_t
        move.w  tx_decoded_columns_bits(a2),d5
        movea.l tx_decoded_quads(a2),a4
        move.l  #$00ff00ff,d7
        move.l  #$001f001f,d4
        lea     tx_weights_table,a5
        lea     tx_weights,a6
        lea     .weighed(pc),a3
        bra.s   .first
.weighed
        lsr.l   #8,d3                   ; -G-A
        eor.l   d2,d3
        and.l   d7,d3
        eor.l   d3,d2
        move.l  d2,(a1)+
        cmpa.l  (sp),a0
        beq.s   .done
.first  move.l  (a0)+,d0                ; s:t
        moveq   #0,d2
        move.l  d0,d1
        and.l   d6,d0
        and.l   d4,d1
        move.w  d0,d2
        lsl.l   d5,d2
        swap    d0
        or.w    d0,d2
        move.l  d1,d3
        lsr.l   #8,d3
        lsr.l   #3,d3
        or.w    d3,d1                   ; fs << 5 | ft
        move.w  (a5,d1.w*2),d1
        lea     (a4,d2.l*2),a2
        jmp     (a6,d1.w)
.done   addq.l  #4,sp
        return_all
