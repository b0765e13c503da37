        include "glide.i"

; glide_walk_clamp - a level's coordinates without perspective, clamped
;
; like:    glide_walk
; formats: 14.18 modulo 2^32 to s:t: (s >> shift) - half, clamped to 0 to last_s, or modulo 2^16
;          if that is 0xffff
; cost:    bench rows glide_walk_clamp, glide_walk_inside

; A line with both ends inside needs no clamping.

        xref    glide_walk

FEW     equ     5                       ; pixels: for fewer, testing the ends takes as long

        pass    glide_walk_clamp
        movem.l d2-d7/a3-a4,-(sp)
        glide_last glide_steps_last_s,a3,d1
        glide_last glide_steps_last_t,a4,d1
        moveq   #0,d6
        move.w  glide_steps_shift(a2),d6
        moveq   #0,d7
        move.w  glide_steps_half(a2),d7
        subq.l  #1,d0
        cmp.l   #FEW-1,d0
        blt.s   .clamp
        move.l  (a0),d1
        move.l  glide_steps_s(a2),d2
        move.l  a3,d3
        bsr.s   .ends
        bhi.s   .clamp
        move.l  glide_iterators_t(a0),d1
        move.l  glide_steps_t(a2),d2
        move.l  a4,d3
        bsr.s   .ends
        bhi.s   .clamp
        addq.l  #1,d0
        movem.l (sp)+,d2-d7/a3-a4
        jmp     glide_walk

        ; Returns the condition "higher" if an end of the iterator d1 with step d2 is outside, or
        ; the last value does not fit 32 bits. In: d3 last, d0 count - 1
.ends   move.l  d1,d4
        asr.l   d6,d4
        sub.l   d7,d4
        cmp.l   d3,d4
        bhi.s   .ended
        move.l  d0,d4
        muls.l  d2,d4
        bvs.s   .long
        add.l   d1,d4
        bvs.s   .long
        asr.l   d6,d4
        sub.l   d7,d4
        cmp.l   d3,d4
.ended  rts
.long   andi    #0,ccr                  ; neither lower nor the same
        rts

.clamp  move.l  d0,d5
        movem.l (a0),d0-d1
        lea     4(a1,d5.l*4),a0         ; end
        movem.l (a2),d2-d3
        glide_clamp_pixels
        movem.l (sp)+,d2-d7/a3-a4
        rts
        glide_clamp_outside
