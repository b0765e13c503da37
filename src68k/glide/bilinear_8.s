        include "n64.i"

; glide_bilinear_8 - texels by the bilinear filter, weights of 8 bits
;
; like:    glide_bilinear
; in:      a2  const glide_decoded*  the level, with quads of 8 bits
; formats: s:t, both 8.8 modulo 2^16; weights of 1/65536, the sum cut to 8 bits

; 256 U and 256 L, 16 bits each, are the values between the columns on the upper and on the lower
; row, two channels in a product. The sum is 65536 U + 256 ft (L - U); its part below 256 may be
; dropped early: 256 U + (ft (L - U) >> 8), modulo 2^16. If L - U borrows, the product is ft * 65536
; too large.

; d2 = a pair's sums, in words; their upper bytes are the channels. Moves a2 to the next pair.
; d3 = fs, d7 = ft << 8. Uses d0, d1, d4.
sums    macro
        move.l  (a2)+,d2
        muls.l  d3,d2
        add.l   (a2)+,d2
        move.l  (a2)+,d4
        muls.l  d3,d4
        add.l   (a2)+,d4
        move.w  d4,d0
        sub.w   d2,d0
        subx.w  d1,d1
        mulu.w  d7,d0
        and.w   d7,d1
        swap    d0
        sub.w   d1,d0
        swap    d2
        swap    d4
        sub.w   d2,d4
        subx.w  d1,d1
        mulu.w  d7,d4
        and.w   d7,d1
        swap    d4
        sub.w   d1,d4
        add.w   d4,d2
        swap    d2
        add.w   d0,d2
        endm

        pass    glide_bilinear_8
        save_all
        lea     (a0,d0.l*4),a6
        move.l  glide_decoded_mask_s(a2),d6     ; and mask_t
        lsl.l   #4,d6
        move.w  glide_decoded_columns_bits(a2),d5
        movea.l glide_decoded_quads(a2),a4
        movea.l #$00ff00ff,a5
        moveq   #0,d3
.pixels move.l  (a0)+,d0                ; s:t
        moveq   #0,d2
        move.l  d0,d7
        and.l   d6,d0
        n64_index
        lsr.l   #3,d2
        lea     (a4,d2.l),a2
        swap    d7
        move.b  d7,d3
        swap    d7
        lsl.w   #8,d7
        sums                            ; R-B-
        movea.l d2,a3
        sums                            ; G-A-
        move.l  a3,d0
        move.l  a5,d1
        lsr.l   #8,d2
        eor.l   d0,d2
        and.l   d1,d2
        eor.l   d2,d0
        move.l  d0,(a1)+
        cmpa.l  a6,a0
        bne     .pixels
        return_all
