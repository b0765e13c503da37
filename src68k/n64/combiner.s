        include "routine.i"

; n64_combiner - one channel of the colour combiner, any inputs
;
; in:      a0  void*  not read
;          a1  int16*  the channel of the results, one n64_wide a pixel
;          a2  const n64_combination*  A, B, C, D
; writes:  a word of each pixel
; formats: (A - B) * C + 256 * D + 128 >> 8 as 9 bits, which are read as those of A, B and D
;          are: -128 to 383. Inputs are such numbers or others of 9 bits; C is read as 9
;          bits signed
        pass    n64_combiner
        save_all
        movea.l a1,a4
        move.l  d0,d3
        lsl.l   #3,d3
        lea     (a1,d3.l),a5            ; end
        movea.l n64_combination_a(a2),a0
        movea.l n64_combination_b(a2),a1
        movea.l n64_combination_c(a2),a6
        movea.l n64_combination_d(a2),a3
        movem.l n64_combination_a_step(a2),d4-d7
        movea.l a6,a2
        movea.l #$8000,a6
        move.w  #128,d2
        move.w  #511,d3
.pixels move.w  (a2),d1
        adda.l  d6,a2
        move.w  (a0),d0
        adda.l  d4,a0
        lsl.w   #7,d1
        sub.w   (a1),d0
        adda.l  d5,a1
        muls.w  d1,d0
        add.l   d0,d0                   ; 65536 of the result's units
        add.l   a6,d0
        swap    d0
        add.w   (a3),d0
        adda.l  d7,a3
        add.w   d2,d0
        and.w   d3,d0
        sub.w   d2,d0
        move.w  d0,(a4)
        addq.l  #n64_wide_sizeof,a4
        cmpa.l  a5,a4
        bne.s   .pixels
        return_all
