; Parts shared by the passes over a line's pixels (structs: c/n64/passes.h).

        include "routine.i"

; Filters the texels of the d0 relative coordinates at a0 to a1, by the parts of n64_weights that
; the table \1 lists (see n64_threepoint). \2: the macro that writes a texel, \3: its value of d7.
n64_filter macro
        xref    \1
        save_all
        lea     (a0,d0.l*4),a6
        move.l  n64_decoded_mask_s(a2),d6       ; and mask_t
        move.w  n64_decoded_columns_bits(a2),d5
        movea.l n64_decoded_quads(a2),a4
        move.l  #\3,d7
        move.l  #$001f001f,d4
        lea     \1,a5
        lea     .weighed(pc),a3
        bra.s   .coordinates
.weighed
        \2
        cmpa.l  a6,a0
        beq.s   .done
.coordinates
        move.l  (a0)+,d0                ; s:t
        n64_quad_find
        move.w  (a5,d1.w*2),d1
        jmp     (a5,d1.w)
.done   return_all
        endm

; a2 = the quad of the s:t in d0, d1 = fs << 5 | ft. In: a4 the tile's quads, d4 = 001f001f, d5 =
; columns_bits, d6 masks. Uses d2-d3.
n64_quad_find macro
        moveq   #0,d2
        move.l  d0,d1
        and.l   d6,d0
        and.l   d4,d1
        n64_index
        move.l  d1,d3
        lsr.l   #8,d3
        lsr.l   #3,d3
        or.w    d3,d1
        lea     (a4,d2.l*2),a2
        endm

; Writes the texel d2, R-B-, and d3, G-A-: all bytes, or 5/5/5/1.
n64_write macro
        lsr.l   #8,d3                   ; -G-A
        eor.l   d2,d3
        and.l   d7,d3                   ; 00ff00ff
        eor.l   d3,d2
        move.l  d2,(a1)+
        endm

n64_write_16 macro
        lsr.l   #5,d3                   ; G and A moved beside R and B
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

; d2 = row << columns_bits | column of the masked s:t in d0, in their units. In: d2 = 0, d5 =
; columns_bits.
n64_index macro
        move.w  d0,d2
        lsl.l   d5,d2
        swap    d0
        or.w    d0,d2
        endm

; For a loop of 8 pixels a round that is entered in its middle: d7 = rounds - 1, d6 = pixels
; that the first round lacks. In: d0 count.
n64_rounds macro
        moveq   #7,d7
        move.l  d0,d6
        neg.l   d6
        and.l   d7,d6                   ; pixels the first round lacks
        move.l  d0,d7
        subq.l  #1,d7
        lsr.l   #3,d7
        endm

; A whole routine: point-samples the texels of the s:t at a0 to a1, 8 a round. \1: the struct at a2,
; \2: right shift of the texel's index d2, \3: the index operand, with its scale.
n64_texels macro
        movem.l d2-d7/a2-a3,-(sp)
        n64_rounds
        move.l  \1_mask_s(a2),d4       ; and mask_t
        move.w  \1_columns_bits(a2),d5
        movea.l \1_texels(a2),a2
        lsl.l   #2,d6
        lea     .pixels(pc,d6.l),a3
        jmp     (a3,d6.l*4)
.pixels rept    8
        move.l  (a0)+,d0                ; 20 bytes
        moveq   #0,d2
        and.l   d4,d0
        n64_index
        lsr.l   #\2,d2
        move.l  (a2,\3),(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
        endm

; Writes s:t, the integers of d0 and d1 in 16.16, to a1, 8 pixels a round; d2, d3 their steps,
; d6 and d7 as n64_rounds leaves them. s is SSss; t is swapped, ttTT, so that its integer is in the
; lower word. Uses d4-d5/a0.
n64_step macro
        swap    d1
        move.l  d3,d5
        swap    d5                      ; --TT
        swap    d3
        clr.w   d3                      ; tt--
        lea     .pixels(pc,d6.l*4),a0
        jmp     (a0,d6.l*8)
.pixels rept    8
        move.l  d0,d4                   ; 12 bytes
        move.w  d1,d4
        add.l   d2,d0
        add.l   d3,d1
        addx.w  d5,d1
        move.l  d4,(a1)+
        endr
        dbra    d7,.pixels
        endm

; \1 = the word nearest to the longword \1, which is outside a word's range.
n64_nearest macro
        add.l   \1,\1
        subx.w  \1,\1                   ; -1 below 0
        eori.w  #$7fff,\1
        endm

; Opens a conversion of YUV texels: a6 = their end, and what n64_converted takes except d6.
n64_convert_open macro
        save_all
        lea     (a0,d0.l*4),a6
        movea.l n64_yuv_conversion_chroma(a2),a3
        movea.l n64_yuv_conversion_matrix(a2),a4
        lea     n64_matrix_v(a4),a5
        endm

; Converts the pixel at a0 with the chroma at a3: d0 = Y, d1-d3 = R, G, B, words of which only the
; lower 9 bits are right. In: a4, a5 the tables of U and V, d6 = 255. The upper words of d0 and d1
; are ignored.
n64_converted macro
        move.w  (a3),d1
        addq.l  #4,a3
        move.w  d1,d0
        lsr.w   #8,d0                   ; U
        and.w   d6,d1                   ; V
        move.l  (a4,d0.w*4),d2
        move.w  d2,d3
        add.l   (a5,d1.w*4),d2
        move.l  (a0)+,d0
        move.w  d2,d1
        swap    d2
        sub.w   d3,d1
        lsr.w   #7,d2
        and.w   d6,d0                   ; Y
        add.w   d0,d1
        add.w   d0,d2
        add.w   d0,d3
        endm

; Goes to \1 if 2 t - u leaves a byte in one of two channels. In: \2 = t of both, \3 = u - t.
; Destroys d5.
n64_inside macro
        move.l  \2,d5
        sub.l   \3,d5
        and.l   #$ff00ff00,d5
        bne     \1
        endm

; Ends a linear interpolation to another texel, two channels in a product: d3 = d4, the product of
; G and A, plus 256 times the texel's -G-A; d1 = the product of R and B. In: d0 = R-B- of the texel,
; d1 = R G B A of the other, d2 factor, d3 = -G-A, d4, d7 = 00ff00ff. Uses d4. \1: n64_inside's, if
; given.
n64_between macro
        lsl.l   #8,d3
        lsr.l   #8,d1
        add.l   d4,d3
        move.l  d0,d4
        and.l   d7,d1
        lsr.l   #8,d4
        sub.l   d4,d1
        ifnb    \1
        n64_inside \1,d4,d1
        endc
        muls.l  d2,d1
        endm

; \1 = the larger one of |\1| and |\2|, of a negative number its one's complement. Destroys \2.
n64_magnitude macro
        tst.l   \1
        minus   <not.l \1>
        tst.l   \2
        minus   <not.l \2>
        cmp.l   \1,\2
        ble.s   .magnitude\@
        move.l  \2,\1
.magnitude\@
        endm

; Goes to \1 unless no quotient of a line is clamped, as shown by its two ends. In: a0 iterators, a2
; their steps, d0 count, d4: N64_GUARD, and with \2 (if given: any word) the most that |s| or |t|
; grows and that w falls to the pixel below; a4: then what w changes by to it. Destroys d1-d7.
;
; Why: the ends are the first pixel and the one that follows the last. If w >= max(|s|, |t|) + N64_GUARD
; holds at both, it holds at all pixels, as the iterators are linear; with the growth in d4 it holds
; at the pixels below, too. None of these sums overflows, so none is taken modulo 2^32. Gradients are cut by
; less than 2^15 and one's complements add 1, so in upper words |S| <= W - 61, and W is above 61. A
; reciprocal R of W is at most 2^31 (1 + 2^-12) / W: rounding adds 2^-14, a chord of the table's
; curve 2^-15. W is below 2^15, so |S| R <= 2^31 (1 + 2^-12) (1 - 61 / 2^15) < 2^31, and S R / 2^16
; fits 16 bits.
N64_GUARD equ   64<<16

n64_guard macro
        move.l  d4,d7
        movem.l (a0),d1-d3
        move.l  d1,d4
        move.l  d2,d5
        n64_guard_end \1,\2
        movem.l (a2),d4-d6
        muls.l  d0,d4
        bvs     \1
        muls.l  d0,d5
        bvs     \1
        muls.l  d0,d6
        bvs     \1
        add.l   d1,d4
        bvs     \1
        add.l   d2,d5
        bvs     \1
        add.l   d6,d3
        bvs     \1
        n64_guard_end \1,\2
        endm

; One end: s in d4, t in d5, w in d3.
n64_guard_end macro
        n64_magnitude d4,d5
        add.l   d7,d4
        bvs     \1
        cmp.l   d4,d3
        blt     \1
        ifnb    \2
        move.l  d3,d4
        add.l   a4,d4
        bvs     \1
        endc
        endm
