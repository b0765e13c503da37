        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tmu_point - texels by point sampling
;
; in:      a0  const tmu_coordinates*  coordinates
;          a1  uint32*  texels, R G B A
;          a2  const tmu_decoded*  the level
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the coordinates, the level, its texels
; writes:  the texels
; formats: s:t, both 12.4 modulo 2^16
; error:   none
; cost:    bench row tmu_point
;==============================================================================
        routine tmu_point,a0,a1,a2,d0
        movem.l d2-d7/a2-a3,-(sp)
        tx_rounds
        move.l  tmu_decoded_mask_s(a2),d4       ; and mask_t
        move.w  tmu_decoded_columns_bits(a2),d5
        movea.l tmu_decoded_texels(a2),a2
        lsl.l   #2,d6
        lea     .pixels(pc,d6.l),a3
        jmp     (a3,d6.l*4)
.pixels rept    8
        move.l  (a0)+,d0                ; 20 bytes
        moveq   #0,d2
        and.l   d4,d0
        tx_index
        lsr.l   #2,d2
        move.l  (a2,d2.l),(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
