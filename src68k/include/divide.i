; Parts of glide_divide (see there for the letters), each used once. They use its registers, its stack and its
; labels.

        include "quotient.i"

; Where w falls: goes to .gentle, .nearer or .sooner. In: d6 = |u| of the second pixel or more, d7 = |g| + 3.
; Uses d1, d5.
judge_falling macro
.falls  move.l  w(a0),d1
        move.w  w_end(sp),d5            ; its upper half
        beq     .nearer
        lsr.l   #8,d1
        lsr.l   #5,d1
        divu.w  d5,d1
        bvs     .nearer
        cmp.w   #254,d1
        bhi     .nearer
        addq.w  #2,d1                   ; for the bits cut off: 8 times the ratio, or a little more
        mulu.w  d1,d1
        move.l  d7,d5
        mulu.l  d1,d5
        bvs     .nearer
        lsr.l   #6,d5
        addq.l  #1,d5                   ; (|g| + 3) f
        move.l  part(sp),d1
        mulu.l  d5,d1
        bvs     .nearer
        add.l   d6,d1
        cmp.l   reach(sp),d1
        bhs     .nearer
        move.l  dw(a2),d1
        neg.l   d1
        add.l   d1,d1
        mulu.l  d1,d5                   ; A
        bvs.s   .sooner
        lsl.l   #3,d1
        cmp.l   w_end(sp),d1
        bhi.s   .sooner
        move.l  d5,d1
        lsr.l   #3,d1
        cmp.l   w_end(sp),d1
        bhi.s   .sooner
        move.l  w_end(sp),d1
        lsr.l   #1,d1
        add.l   d5,d1
        bcs.s   .sooner
        cmp.l   #LIMIT,d1
        bhi.s   .sooner
        move.l  w(a0),d1
        lsr.l   #1,d1
        add.l   d1,d5
        cmp.l   #LIMIT,d5
        bls     .gentle
        move.l  dw(a2),d5
        neg.l   d5
        add.l   d5,d5
        mulu.l  d7,d5                   ; A with f = 1
        add.l   d1,d5
        cmp.l   #LIMIT,d5
        bls     .gentle
        endm

; A pixel of divide_steep.
steep   macro
        move.l  a3,d0
        move.l  a4,d1
        move.l  d0,d4
        move.l  d1,d5
        lsr.l   d6,d4
        lsr.l   d6,d5
        lsl.l   d7,d0
        lsl.l   d7,d1
        divu.l  d2,d4:d0
        divu.l  d2,d5:d1
        sub.w   a0,d0
        sub.w   a0,d1
        adda.l  a5,a3
        adda.l  a6,a4
        swap    d0
        add.l   d3,d2
        move.w  d1,d0
        move.l  d0,(a1)+
        endm

; The part from its third pixel on, by division. In: d2 = the second pixel's w.
divide_steep macro
.exact  movem.l (a2),d3-d5
        movea.l d3,a5
        movea.l d4,a6
        adda.l  d5,a5
        adda.l  d5,a5
        adda.l  d5,a6
        adda.l  d5,a6                   ; the steps of s + 2 w and t + 2 w
        add.l   s(a0),d3
        add.l   t(a0),d4
        add.l   d2,d3
        add.l   d2,d3
        add.l   d2,d4
        add.l   d2,d4
        add.l   d5,d2
        lea     (a5,d3.l),a3
        lea     (a6,d4.l),a4
        move.l  d5,d3
        move.l  bits(sp),d7
        moveq   #32,d6
        sub.l   d7,d6
        moveq   #2,d0
        lsl.l   d7,d0
        add.w   glide_steps_half(a2),d0
        move.l  a0,from(sp)
        movea.l d0,a0
        move.l  part(sp),d1
        lea     (a1,d1.l*4),a2
        addq.l  #8,a1
        lsr.l   #1,d1
        bcs.s   .second                 ; an odd number is left
.third  steep
.second steep
        cmpa.l  a2,a1
        bne.s   .third
        bra     .drawn
        endm

; d0 pixels, one by one, axis by axis.
divide_tested macro
.divide move.l  d0,part(sp)
        subq.l  #1,d0
        move.l  d0,last(sp)
        moveq   #1,d1
        move.w  d1,axis(sp)
        move.l  bits(sp),d7
        lsl.l   d7,d1
        subq.l  #1,d1
        move.l  d1,mask(sp)
        moveq   #0,d1
        move.w  glide_steps_half(a2),d1
        movea.l d1,a4
        move.l  s(a0),d0
        move.l  ds(a2),d1
        moveq   #0,d4
        move.w  glide_steps_last_s(a2),d4
.axis   addq.w  #1,d4                   ; 0xffff becomes 2^32 - 1
        subq.l  #1,d4
        movea.l d4,a5
        move.l  last(sp),d4
        lea     4(a1,d4.l*4),a3         ; end
        move.l  w(a0),d2
        move.l  dw(a2),d3
        move.l  bits(sp),d7
.tested move.l  d2,d4
        ble     .odd
        move.l  d0,d5
        movea.l d0,a6
.known  magnitude d5
        move.l  d5,d6
        lsr.l   #1,d6
        cmp.l   d4,d6
        bhs     .cut
        divided
.write  put     d5
        add.l   d1,d0
        add.l   d3,d2
        cmpa.l  a3,a1
        bne.s   .tested
.axis_done
        subq.w  #1,axis(sp)
        bmi.s   .divided
        move.l  last(sp),d0
        not.l   d0
        lea     2(a3,d0.l*4),a1         ; t of the first pixel
        move.l  t(a0),d0
        move.l  dt(a2),d1
        moveq   #0,d4
        move.w  glide_steps_last_t(a2),d4
        bra     .axis
.divided
        lea     -2(a3),a1
        bra     .next

.odd    beq.s   .none
        tst.w   glide_steps_behind(a2)
        bne.s   .none
        neg.l   d4
        move.l  d0,d5
        not.l   d5                      ; the other sign
        movea.l d5,a6
        move.l  d0,d5
        bne     .known
.none   moveq   #0,d5
        sub.l   a4,d5
        bra     .write
.cut    move.l  mask(sp),d5
        addq.l  #1,d5
        add.l   d5,d5
        subq.l  #1,d5
        move.l  a6,d4
        minus   <not.l d5>
        sub.l   a4,d5
        bra     .write
        endm

; Pixels whose w = d2 is 0 or negative: those of a negative w are filled if they are behind. In: d0 = left.
fill_behind macro
.behind beq     .unlike
        tst.w   glide_steps_behind(a2)
        beq     .unlike
        move.l  d0,part(sp)
        move.l  dw(a2),d1
        beq.s   .fill
        bpl.s   .rises
        neg.l   d1
        bclr    #31,d2                  ; to the least number
        bra.s   .sign
.rises  not.l   d2                      ; to -1
.sign   divu.l  d1,d2
        addq.l  #1,d2
        cmp.l   d0,d2
        bhs.s   .fill
        move.l  d2,part(sp)
.fill   moveq   #0,d0
        sub.w   glide_steps_half(a2),d0
        move.w  d0,d1
        cmpi.w  #-1,glide_steps_last_s(a2)
        beq.s   .free_s
        moveq   #0,d0
.free_s cmpi.w  #-1,glide_steps_last_t(a2)
        beq.s   .free_t
        moveq   #0,d1
.free_t swap    d0
        move.w  d1,d0
        move.l  part(sp),d7
.filled move.l  d0,(a1)+
        subq.l  #1,d7
        bne.s   .filled
        bra     .next
        endm

; Clamps the part, then goes to .next.
clamp_part macro
.clamps move.l  part(sp),d0
        neg.l   d0
        lea     (a1,d0.l*4),a3
        move.w  glide_steps_last_s(a2),d1
        bsr.s   .clamp
        addq.l  #2,a3
        move.w  glide_steps_last_t(a2),d1
        pea     .next(pc)

        ; Clamps the words of -d0 pixels from a3 on to 0 to d1. Uses d2-d3/a4.
.clamp  move.l  d0,d3
        not.l   d3
        cmp.w   (a3),d1
        blo.s   .over
        cmp.w   (a3,d3.l*4),d1
        bhs.s   .clamped
.over   movea.l a3,a4
.word   move.w  (a4),d2
        cmp.w   d2,d1
        bhs.s   .inside
        tst.w   d2
        bmi.s   .below
        move.w  d1,(a4)
        bra.s   .inside
.below  clr.w   (a4)
.inside addq.l  #4,a4
        dbra    d3,.word
.clamped
        rts
        endm
