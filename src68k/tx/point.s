        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tx_point - texels by point sampling
;
; in:      a0  const tx_coordinates*  relative coordinates
;          a1  uint32*  texels, R G B A
;          a2  const tx_decoded*  the tile
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the coordinates, the tile, its texels
; writes:  the texels
; formats: s:t, both s10.5 modulo 2^16
; error:   none
; cost:    bench row tx_point
;==============================================================================
        routine tx_point,a0,a1,a2,d0
        movem.l d2-d7/a2-a3,-(sp)
        tx_rounds
        move.l  tx_decoded_mask_s(a2),d4        ; and mask_t
        move.w  tx_decoded_columns_bits(a2),d5
        movea.l tx_decoded_texels(a2),a2
        lsl.l   #2,d6
        lea     .pixels(pc,d6.l),a3
        jmp     (a3,d6.l*4)
.pixels rept    8
        move.l  (a0)+,d0                ; 20 bytes
        moveq   #0,d2
        and.l   d4,d0
        move.w  d0,d2
        lsl.l   d5,d2
        swap    d0
        or.w    d0,d2
        lsr.l   #5,d2
        move.l  (a2,d2.l*4),(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
