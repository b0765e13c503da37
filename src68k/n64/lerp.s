        include "n64.i"

; n64_lerp - linear interpolation between texels
;
; in:      a0  const uint32*  texels 0, R G B A
;          a1  uint32*  texels; may be the same memory
;          a2  const n64_blend*  texels 1 and their fractions
; formats: fractions of 256, -256 to 255: (texel 1 - texel 0) * fraction + 256 * texel 0 +
;          128 >> 8, its 9 bits clamped: 256 to 383 are 255, 384 to 511 are 0

; Two channels in one product: neither overflows its word unless the fraction is negative.
; Then each channel is multiplied alone.

        pass    n64_lerp
        save_all
        lea     (a0,d0.l*4),a6
        movea.l n64_blend_other(a2),a3
        movea.l n64_blend_fractions(a2),a4
        movea.l n64_blend_fraction_step(a2),a5
        move.l  #$00ff00ff,d7
        move.l  #$00800080,d6
.pixels move.l  (a0)+,d0
        move.l  (a3)+,d1
        move.w  (a4),d2
        adda.l  a5,a4
        beq.s   .write
        ext.l   d2
        bmi.s   .beyond
        move.l  d0,d3
        move.l  d1,d4
        and.l   d7,d3                   ; -G-A
        and.l   d7,d4
        sub.l   d3,d4
        muls.l  d2,d4
        eor.l   d3,d0                   ; R-B-, 256 of each
        n64_between
        add.l   d6,d3
        lsr.l   #8,d3
        add.l   d6,d0
        add.l   d1,d0
        eor.l   d0,d3
        and.l   d7,d3
        eor.l   d3,d0
.write  move.l  d0,(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        return_all

.beyond moveq   #3,d5
.channel
        rol.l   #8,d0
        rol.l   #8,d1
        moveq   #0,d3
        move.b  d0,d3
        moveq   #0,d4
        move.b  d1,d4
        sub.w   d3,d4
        muls.w  d2,d4
        add.l   #128,d4
        asr.l   #8,d4
        add.w   d3,d4
        btst    #8,d4
        beq.s   .fits
        tst.b   d4
        spl     d4
.fits   move.b  d4,d0
        dbra    d5,.channel
        bra.s   .write
