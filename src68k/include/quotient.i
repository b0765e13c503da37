; Parts of glide_divide: quotients by division, or by differences from the last one (see there for
; the letters). They use its registers and its stack.

        include "routine.i"

; |\1|
magnitude macro
        tst.l   \1
        minus   <neg.l \1>
        endm

; \1 = u and \2 = r of the iterator \1. In: d2 = w, d7 = bits, d6 = 32 - bits.
quotient macro
        move.l  \1,\2
        asr.l   d6,\2
        lsl.l   d7,\1
        divs.l  d2,\2:\1
        bvs     .unlike
        tst.l   \2
        minus   <subq.l #1,\1>,<add.l d2,\2>
        endm

; \1 and d0 = the coordinates of u = d0 and d1, less d5 = half. Uses d1.
packed  macro
        sub.l   d5,d0
        sub.l   d5,d1
        swap    d0
        move.w  d1,d0
        move.l  d0,\1
        endm

; The remainder \1, its change \2 and the change's own \3 at the next pixel. Goes to \4 if \1 is outside 0 to
; w - 1, w = d1; wrong comes back to \5.
step    macro
        add.l   \2,\1
        cmp.l   d1,\1
        bhs.s   \4
\5      sub.l   \3,\2
        endm

NEGATIVE equ    $a0000000               ; r from here on is negative

; \1 is where step goes to, \2 where it goes on. \3 = r, \4 = e, \5 = gg; \6 and \7 make u one more or less, \8
; and \9 g. In: a0 = dw, d1 = w. Uses a5.
wrong   macro
\1      cmp.l   #NEGATIVE,\3
        bhs.s   .low\@
        \6
        sub.l   d1,\3
        movea.l d1,a5
        suba.l  \4,a5
        cmp.l   a5,\4                   ; e > w - e
        bgt.s   .up\@
        sub.l   a0,\4
        cmp.l   d1,\3
        blo.s   \2
        bra.s   \1
.up\@   \8
        add.l   a0,\5
        add.l   a0,\5
        sub.l   d1,\4
        cmp.l   d1,\3
        blo.s   \2
        bra.s   \1
.low\@  \7
        add.l   d1,\3
        movea.l d1,a5
        adda.l  \4,a5
        adda.l  \4,a5
        tst.l   a5                      ; w + 2 e < 0
        bmi.s   .down\@
        add.l   a0,\4
        cmp.l   d1,\3
        blo.s   \2
        bra.s   \1
.down\@ \9
        sub.l   a0,\5
        sub.l   a0,\5
        add.l   d1,\4
        cmp.l   d1,\3
        blo.s   \2
        bra.s   \1
        endm

; d5 = u - half from the magnitudes d5 = s and d4 = w; a6 has the quotient's sign. In: d7 = bits. Uses d4, d6.
divided macro
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
.up\@   sub.l   a4,d5
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
