; What the passes over a line's pixels share (structs: c/tx/passes.h).

; The texels of relative coordinates by the parts of tx_weights, through the table \1: see
; tx_threepoint. \2: what writes a texel, \3: d7 for it.
tx_filter macro
        xref    tx_weights,\1
        save_all
        lea     (a0,d0.l*4),a3
        move.l  a3,-(sp)
        move.l  tx_decoded_mask_s(a2),d6        ; and mask_t
        move.w  tx_decoded_columns_bits(a2),d5
        movea.l tx_decoded_quads(a2),a4
        move.l  #\3,d7
        move.l  #$001f001f,d4
        lea     \1,a5
        lea     tx_weights,a6
        lea     .weighed(pc),a3
        bra.s   .coordinates
.weighed
        \2
        cmpa.l  (sp),a0
        beq.s   .done
.coordinates
        move.l  (a0)+,d0                ; s:t
        moveq   #0,d2
        move.l  d0,d1
        and.l   d6,d0
        and.l   d4,d1
        tx_index
        move.l  d1,d3
        lsr.l   #8,d3
        lsr.l   #3,d3
        or.w    d3,d1                   ; fs << 5 | ft
        move.w  (a5,d1.w*2),d1
        lea     (a4,d2.l*2),a2
        jmp     (a6,d1.w)
.done   addq.l  #4,sp
        return_all
        endm

; Writes the texel d2, R-B-, and d3, G-A-: all bytes, or 5/5/5/1.
tx_write macro
        lsr.l   #8,d3                   ; -G-A
        eor.l   d2,d3
        and.l   d7,d3                   ; 00ff00ff
        eor.l   d3,d2
        move.l  d2,(a1)+
        endm

tx_write_16 macro
        lsr.l   #5,d3                   ; G and A as they are beside R and B
        eor.l   d2,d3
        and.l   d7,d3                   ; 07c00400
        eor.l   d3,d2
        move.w  d2,d3
        swap    d2
        lsr.w   #8,d3
        and.w   #$ffc0,d2
        lsr.w   #2,d3
        or.w    d3,d2
        move.w  d2,(a1)+
        endm

; d2 = 32 * (row << columns_bits | column) of the masked s:t in d0; d2 was 0, d5
; columns_bits.
tx_index macro
        move.w  d0,d2
        lsl.l   d5,d2
        swap    d0
        or.w    d0,d2
        endm

; For a loop of 8 pixels a round that is entered in its middle: d7 = rounds - 1, d6 = pixels
; that the first round lacks. In: d0 count.
tx_rounds macro
        moveq   #7,d7
        move.l  d0,d6
        neg.l   d6
        and.l   d7,d6                   ; pixels the first round lacks
        move.l  d0,d7
        subq.l  #1,d7
        lsr.l   #3,d7
        endm

; Point sampling: texels of size \1, l or w, \2 bytes each.
tx_sample macro
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
        move.\1 (a2,d2.l*\2),(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
        endm

; Perspective: see tx_divide. \1: anything where w and the results are to be checked.
; s * 65536 * reciprocal: the upper half of the product is the quotient.
tx_divide_line macro
        save_all
        move.l  d0,d7
        movem.l (a0),d0-d2
        movem.l (a2),d3-d5
        movea.l d3,a4
        movea.l d4,a5
        movea.l d5,a6
        movea.l tx_division_reciprocals(a2),a3
        lea     (a1,d7.l*4),a0
.pixels move.l  d2,d3
        swap    d3
        ifnb    \1
        tst.w   d3
        ble.s   .bad
        endc
        move.l  (a3,d3.w*4),d3
        move.l  d0,d4
        clr.w   d4
        muls.l  d3,d5:d4
        move.l  d1,d4
        clr.w   d4
        muls.l  d3,d6:d4
        ifnb    \1
        movea.w d5,a2
        cmpa.l  d5,a2
        bne.s   .far_s
.s      movea.w d6,a2
        cmpa.l  d6,a2
        bne.s   .far_t
.t
        endc
        swap    d5
        move.w  d6,d5
.write  move.l  d5,(a1)+
        add.l   a4,d0
        add.l   a5,d1
        add.l   a6,d2
        cmpa.l  a0,a1
        bne.s   .pixels
        return_all
        ifnb    \1
.bad    move.l  #$7fff7fff,d5
        bra.s   .write
.far_s  tx_nearest d5
        bra.s   .s
.far_t  tx_nearest d6
        bra.s   .t
        endc
        endm

; The word of \1 that is nearest to the long.
tx_nearest macro
        add.l   \1,\1
        subx.w  \1,\1                   ; -1 below 0
        eori.w  #$7fff,\1
        endm
