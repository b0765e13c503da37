; Parts of glide_pieces: quotients, steps, coordinates. They use its registers and its stack.

        include "glide.i"

; \1 = 2^30 * \1 / d3, s / w, rounded down; w is above 0. Goes to \2 if that does not fit 32 bits.
; In: d5 = 2 w, d4 = 30. Uses d2.
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
        minus   <subq.l #1,\1>
        endm

; d0, d1 = the quotients of a3 and a4 by d3; goes to \1 if one does not fit. Uses d2/d4-d5.
quotients macro
        move.l  d3,d5
        add.l   d5,d5
        moveq   #30,d4
        move.l  a3,d0
        quotient d0,\1
        move.l  a4,d1
        quotient d1,\1
        endm

; Shifts s and t (d0, d1) and their steps (d2, d3) left by d5, subtracts a6 from s and t, and swaps
; as n64_step does: d0 = SSss, d1 = ttTT, d3 = tt--, d5 = TT.
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
        minus   <subq.l #1,\1>
        endm

; Goes to .single if the value d4 is not in 0 to \1. d5 = shift. Uses d4.
inside  macro
        asr.l   d5,d4
        sub.l   half(sp),d4
        cmp.l   \1,d4
        bhi     .single
        endm

; d4 = the last value of a whole piece of 2^d5 pixels that begins at \1 and steps by \2.
at_end  macro
        move.l  \2,d4
        lsl.l   d5,d4
        sub.l   \2,d4
        add.l   \1,d4
        endm

; The routines .ends and .both: d0, d1 = the quotients of a3 and a4 by a5 (w). .both also handles w
; of 0 and below, and quotients that do not fit 32 bits. a0 = steps. Uses d2-d5.
quotients_of_ends macro
.ends   move.l  a5,d3
        ble.s   .both
        quotients .both
        rts
.both   move.l  a4,d0
        bsr.s   .one
        move.l  d0,d1
        move.l  a3,d0
.one    move.l  a5,d3
        beq.s   .zero
        bpl.s   .front
        tst.w   glide_steps_behind(a0)
        bne.s   .zero
.front  move.l  d0,d4
        eor.l   d3,d4                   ; negative if the quotient is
        tst.l   d3
        bpl.s   .w
        neg.l   d3
.w      tst.l   d0
        minus   <neg.l d0>
        move.l  d0,d2
        lsr.l   #1,d2
        cmp.l   d3,d2
        bhs.s   .cut
        lsr.l   #1,d2
        moveq   #30,d5
        lsl.l   d5,d0
        divu.l  d3,d2:d0
        tst.l   d4
        bpl.s   .found
        neg.l   d0
        tst.l   d2
        beq.s   .found
        subq.l  #1,d0
.found  rts
.zero   moveq   #0,d0
        rts
.cut    moveq   #-1,d0
        lsr.l   #1,d0
        tst.l   d4
        minus   <not.l d0>
        rts
        endm
