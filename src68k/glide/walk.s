        include "n64.i"

; glide_walk - a level's coordinates without perspective, wrapped
;
; like:    glide_divide
; in:      a0  const glide_iterators*  s and t at the first pixel
; formats: 14.18, without a limit, to s:t: (s >> shift) - half, modulo 2^16
; cost:    bench rows glide_walk, glide_walk_small

; From shift 17 on s and t have more than 16 fraction bits; the excess bits are in separate
; registers.

; Shifts d0 and d1 right by \1; the bits shifted out become the upper bits of \2 and \3. d7 is their
; mask.
low_bits macro
        move.l  d0,\2
        move.l  d1,\3
        ror.l   \1,\2
        ror.l   \1,\3
        and.l   d7,\2
        and.l   d7,\3
        asr.l   \1,d0
        asr.l   \1,d1
        endm

        pass    glide_walk
        movem.l d2-d7/a3-a4,-(sp)
        moveq   #16,d4
        sub.w   glide_steps_shift(a2),d4
        blt     .small
        n64_rounds
        movem.l (a0),d0-d1
        movem.l (a2),d2-d3
        lsl.l   d4,d0
        lsl.l   d4,d1
        lsl.l   d4,d2
        lsl.l   d4,d3
        moveq   #0,d5
        move.w  glide_steps_half(a2),d5
        swap    d5
        sub.l   d5,d0
        sub.l   d5,d1
        n64_step
        movem.l (sp)+,d2-d7/a3-a4
        rts

.small  neg.w   d4
        move.l  d0,d6
        moveq   #-1,d7
        lsr.l   d4,d7
        not.l   d7                      ; the upper d4 bits
        movem.l (a2),d0-d1
        low_bits d4,d2,d3
        movea.l d2,a3
        movea.l d3,a4
        move.l  d6,d5
        move.l  d0,d2
        move.l  d1,d3
        movem.l (a0),d0-d1
        lea     (a1,d5.l*4),a0
        low_bits d4,d5,d6
        moveq   #0,d4
        move.w  glide_steps_half(a2),d4
        swap    d4
        sub.l   d4,d0
        sub.l   d4,d1
.pixel  move.l  d1,d4
        move.l  d0,d7
        swap    d4
        move.w  d4,d7
        add.l   a3,d5
        addx.l  d2,d0
        add.l   a4,d6
        addx.l  d3,d1
        move.l  d7,(a1)+
        cmpa.l  a0,a1
        bne.s   .pixel
        movem.l (sp)+,d2-d7/a3-a4
        rts
