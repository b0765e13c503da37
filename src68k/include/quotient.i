; Parts of glide_divide: quotients by division, or by differences from the last one (see there for
; the letters). They use its registers and its stack.

        include "routine.i"

; d5 = u - half and d6 = r from the magnitudes d5 = s and d4 = w; a6 has the quotient's sign. In:
; d7 = 30 - shift, d2 = w. Uses d4.
quotient macro
        rol.l   d7,d5
        move.l  d5,d6
        and.l   mask(sp),d6
        eor.l   d6,d5
        divu.l  d4,d6:d5
        move.l  a6,d4
        bpl.s   .up\@
        neg.l   d5
        tst.l   d6
        beq.s   .up\@
        subq.l  #1,d5
        neg.l   d6
        add.l   d2,d6
.up\@   sub.l   a4,d5
        endm

; a5 = 2^32 - 1, no clamp, if both ends of the line are inside the clamped axis: then all pixels are,
; as a quotient of linear numbers only rises or only falls while w is above 0. In: d0 = s and d2 = w of
; the first pixel, a6 and w_end(sp) those of the last, d7 = 30 - shift, a4 = half, d5 = |s|. Uses d4, d6.

unclamp macro
        cmpa.w  #-1,a5
        beq.s   .free\@
        cmpi.l  #FEW-1,left(sp)
        blt.s   .free\@                 ; it would not pay
        move.l  d2,d5
        move.l  d0,d4
        inside  .sides\@
        move.l  w_end(sp),d5
        move.l  a6,d4
        inside  .sides\@
        movea.w #-1,a5
.sides\@
        move.l  d0,d5
        magnitude d5
.free\@
        endm

; Goes to \1 unless s = d4 and w = d5 are surely inside. With W = w >> (30 - shift), u - half is 0 or
; more if s >= half (W + 1), and last or less if s < (last + 1 + half) W. Destroys d5-d6.
inside  macro
        lsr.l   d7,d5
        move.l  a5,d6
        add.l   a4,d6
        addq.l  #1,d6
        mulu.l  d5,d6
        cmp.l   d6,d4
        bge.s   \1
        move.l  a4,d6
        addq.l  #1,d5
        mulu.l  d5,d6
        cmp.l   d6,d4
        blt.s   \1
        endm

; d4:d5 = the first pixel's 2^(30 - shift) (s + 2 w), d1:d6 = its step, a6 = 2^(31 - shift) + half.
; In: d0 = s, d1 = its step, d2 = w, d3 = its step, a4 = half. Uses d0, d7.
dividends macro
        moveq   #30,d7
        sub.w   glide_steps_shift(a2),d7
        move.l  d2,d5
        add.l   d5,d5
        add.l   d0,d5
        move.l  d3,d6
        add.l   d6,d6
        add.l   d5,d6
        add.l   d1,d6                   ; s + 2 w of the second pixel
        rol.l   d7,d5
        rol.l   d7,d6
        move.l  mask(sp),d4
        move.l  d4,d1
        and.l   d5,d4
        and.l   d6,d1
        eor.l   d4,d5
        eor.l   d1,d6
        sub.l   d5,d6
        subx.l  d4,d1
        moveq   #2,d0
        lsl.l   d7,d0
        add.l   a4,d0
        movea.l d0,a6
        endm

; d0 = u - half of a pixel; steps to the next one. Uses d7.
sound_quotient macro
        move.l  d5,d0
        move.l  d4,d7
        divu.l  d2,d7:d0
        add.l   d3,d2
        sub.l   a6,d0
        add.l   d6,d5
        addx.l  d1,d4
        endm

; |\1|
magnitude macro
        tst.l   \1
        minus   <neg.l \1>
        endm

; Writes \1, clamped to 0 to a5, or modulo 2^16 if a5 is 2^32 - 1. Uses \1.
put     macro
        cmp.l   a5,\1
        bls.s   .put\@
        tst.l   \1
        bmi.s   .zero\@
        move.l  a5,\1
        bra.s   .put\@
.zero\@ moveq   #0,\1
.put\@  move.w  \1,(a1)
        addq.l  #4,a1
        endm

; Steps to the next pixel by differences. Goes to \1 if r is out of range; correct comes back
; to \2.
step    macro
        add.l   d3,d2
        add.l   d1,d0
        add.l   d5,d4
        cmp.l   d2,d0
        bhs.s   \1
\2      sub.l   d6,d1
        endm

NEGATIVE equ    $a0000000               ; r from here on is negative

; At \1, where r is out of range: corrects it and goes to \2.
correct macro
\1      cmp.l   #NEGATIVE,d0
        bhs.s   .low\@
        addq.l  #1,d4
        addq.l  #1,d5
        add.l   d3,d6
        add.l   d3,d6
        sub.l   d2,d1
        sub.l   d2,d0
        cmp.l   d2,d0
        blo.s   \2
        bra.s   \1
.low\@  subq.l  #1,d4
        subq.l  #1,d5
        sub.l   d3,d6
        sub.l   d3,d6
        add.l   d2,d1
        add.l   d2,d0
        cmp.l   d2,d0
        blo.s   \2
        bra.s   \1
        endm
