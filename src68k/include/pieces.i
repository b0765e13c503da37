; The parts of tmu_pieces: quotients, steps, coordinates. They use its registers and its stack.

; \1 = the quotient of \1 = s by d3 = w, above 0; \2: where 32 bits are too few. d5 = 2 w, d4 = 30.
; Uses d2.
quotient macro
        move.l  \1,d2
        asr.l   #1,d2
        add.l   d3,d2
        cmp.l   d5,d2
        bhs     \2
        sub.l   d3,d2
        asr.l   #1,d2
        lsl.l   d4,\1
        divs.l  d3,d2:\1
        tst.l   d2
        bpl.s   .down\@
        subq.l  #1,\1
.down\@
        endm

; s and t at d0 and d1 and their steps d2 and d3, moved by d5, as tx_step has them: SSss, ttTT,
; tt--, d5 = TT.
scaled  macro
        lsl.l   d5,d0
        lsl.l   d5,d1
        lsl.l   d5,d2
        lsl.l   d5,d3
        sub.l   a6,d0
        sub.l   a6,d1
        swap    d1
        move.l  d3,d5
        swap    d5
        swap    d3
        clr.w   d3
        endm

; \1 = \1 - \2 over d5 pixels, rounded down. Uses d4.
step    macro
        sub.l   \2,\1
        divsl.l d5,d4:\1
        tst.l   d4
        bpl.s   .down\@
        subq.l  #1,\1
.down\@
        endm

; \2 = the last coordinate \1; of a wrapped axis the greatest number of 32 bits. Uses d2.
last    macro
        moveq   #0,d2
        move.w  \1(a2),d2
        addq.w  #1,d2
        subq.l  #1,d2
        move.l  d2,\2
        endm

; On to .single if the value d4 lies outside 0 to \1. d5 = shift. Uses d4.
inside  macro
        asr.l   d5,d4
        sub.l   half(sp),d4
        cmp.l   \1,d4
        bhi     .single
        endm

; d4 = the last value of a whole piece from \1 on by \2. d5 = bits.
at_end  macro
        move.l  \2,d4
        lsl.l   d5,d4
        sub.l   \2,d4
        add.l   \1,d4
        endm
