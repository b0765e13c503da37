        include "n64.i"

; n64_lerp - linear interpolation between texels
;
; in:      a0  const uint32*  texels 0, R G B A
;          a1  uint32*  texels; may be the same memory
;          a2  const n64_blend*  texels 1 and their fractions
; formats: fractions of 256, -256 to 255: (texel 1 - texel 0) * fraction + 256 * texel 0 +
;          128 >> 8, its 9 bits clamped: 256 to 383 are 255, 384 to 511 are 0

; Two channels in one product: neither overflows its word if the results are bytes. With a fraction
; below 0 they are between t = texel 0 and 2 t - texel 1. Where that is no byte each channel is
; multiplied alone.

; d4 = the product of G and A, d3 = -G-A, d0 = R-B- of the texel d0. In: d1 the other, d2 the fraction.
; \1: n64_inside's, if given.
begin   macro
        move.l  d0,d3
        move.l  d1,d4
        and.l   d7,d3
        and.l   d7,d4
        sub.l   d3,d4
        ifnb    \1
        n64_inside \1,d3,d4
        endc
        muls.l  d2,d4
        eor.l   d3,d0
        n64_between \1
        endm

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
        begin
.ended  add.l   d6,d3
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

.beyond begin   .apart
        bra.s   .ended

.apart  move.l  -4(a0),d0
        move.l  -4(a3),d1
        moveq   #3,d5
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
