        include "n64.i"

; glide_walk - a level's coordinates without perspective, wrapped
;
; like:    glide_divide
; in:      a0  const glide_iterators*  s and t at the first pixel
; formats: 14.18, without a limit, to s:t: (s >> shift) - half, modulo 2^16
; cost:    bench rows glide_walk, glide_walk_small

; From shift 17 on s and t have more than 16 fraction bits: 16 + e. s is SSss, its lowest e bits are
; at the upper end of another register, whose carry they are. t is its integer in a lower word and,
; in another register, all of its fraction at the upper end.

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

.small  n64_rounds
        add.l   d6,d6
        move.l  d6,-(sp)
        neg.w   d4                      ; e
        moveq   #32,d5
        sub.w   d4,d5
        move.l  glide_steps_s(a2),d2
        lsl.l   d5,d2
        movea.l d2,a3
        move.l  glide_steps_s(a2),d2
        asr.l   d4,d2
        move.l  glide_iterators_s(a0),d0
        move.l  d0,d1
        lsl.l   d5,d1
        move.l  d1,d5
        asr.l   d4,d0
        moveq   #0,d1
        move.w  glide_steps_half(a2),d1
        swap    d1
        sub.l   d1,d0
        moveq   #16,d6
        add.w   d4,d6
        neg.w   d4
        add.w   #16,d4
        move.l  glide_steps_t(a2),d3
        lsl.l   d4,d3
        movea.l d3,a4
        move.l  glide_steps_t(a2),d3
        asr.l   d6,d3
        move.l  glide_iterators_t(a0),d1
        asr.l   d6,d1
        sub.w   glide_steps_half(a2),d1
        move.l  glide_iterators_t(a0),d6
        lsl.l   d4,d6
        lea     .chain(pc),a0
        move.l  (sp)+,d4
        suba.l  d4,a0
        lsl.l   #3,d4
        jmp     (a0,d4.l)               ; 14 bytes for each pixel the first round lacks
.chain  rept    8
        move.l  d0,d4                   ; 14 bytes
        move.w  d1,d4
        add.l   a3,d5
        addx.l  d2,d0
        add.l   a4,d6
        addx.w  d3,d1
        move.l  d4,(a1)+
        endr
        dbra    d7,.chain
        movem.l (sp)+,d2-d7/a3-a4
        rts
