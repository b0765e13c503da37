        include "quotient.i"

; glide_divide - a level's coordinates with perspective
;
; in:      a0  const glide_iterators*  at the first pixel
;          a1  glide_coordinates*  coordinates
;          a2  const glide_steps*  their steps, the level
; formats: 14.18 and 2.30 modulo 2^32 to s:t: q = s * 2^30 / w rounded down, clamped to 32 bits, 0
;          if w is 0, or negative and behind is 1; (q >> shift) - half, clamped to 0 to last_s, or
;          modulo 2^16 if that is 0xffff
; cost:    bench rows glide_divide, glide_divide_clamp, glide_divide_each

; One axis, then the other. With n = s * 2^(30 - shift) the coordinate is u = n / w rounded down; r
; is the remainder. Two pixels are divided; from then on u grows by g, and r by e, its change if u
; grows by g. If r leaves 0 to w - 1, g was wrong by one or more:
;       u += g    r += e    w += dw
;       while r is outside:  u, g += 1    gg += 2 dw    r -= w    e -= w    (or the other way)
;       e -= gg             where gg = 2 g dw
; All modulo 2^32. That is exact as long as r, before its correction, is known to be between -1.5
; and 2.5 * 2^30. gg bounds it: r leaves -w to 2 w by gg at most. So a line is done this way if w is
; from 1 to 2^30 at both ends, no quotient is clamped, gg + w stays below 1.5 * 2^30 and gg
; below 4 w. A slope is a constant divided by this pixel's w and by the last one's: gg is greatest
; where w is smallest, gg + w at an end.
;
; Other lines are divided pixel by pixel. If w is from 1 to 2^30 and |s| below 2 w at both ends, this is
; so at each pixel, as all are linear. Then s + 2 w is above 0 and below 4 w, 2^32 at most. Times
; 2^(30 - shift) it is stepped in 64 bits: its quotient, u + 2^(31 - shift), fits, and no pixel needs
; a test. The step is the difference of the first two pixels, which holds modulo 2^64.

FEW     equ     16                      ; pixels: shorter lines are divided
MOST    equ     $40000000               ; w
LIMIT   equ     $60000000               ; gg + w

; On the stack.
left    equ     0                       ; count - 1
w_most  equ     4                       ; of the line; 0: no differences
w_least equ     8
fall    equ     12                      ; 64 (first w / last w)^2, or a little more; 64 if w rises
s       equ     16
ds      equ     20
w       equ     24
dw      equ     28
mask    equ     32                      ; 2^(30 - shift) - 1
first_u equ     36
first_r equ     40
w_end   equ     44                      ; 0: w is not from 1 to 2^30 at both ends
axis    equ     48
locals  equ     52

        pass    glide_divide
        save_all
        lea     -locals(sp),sp
        subq.l  #1,d0
        move.l  d0,left(sp)
        move.w  #1,axis(sp)
        moveq   #0,d1
        move.w  glide_steps_half(a2),d1
        movea.l d1,a4
        moveq   #30,d7
        sub.w   glide_steps_shift(a2),d7
        moveq   #1,d1
        lsl.l   d7,d1
        subq.l  #1,d1
        move.l  d1,mask(sp)
        move.l  glide_iterators_w(a0),d2
        move.l  glide_steps_w(a2),d3
        move.l  d2,w(sp)
        move.l  d3,dw(sp)
        clr.l   w_most(sp)
        clr.l   w_end(sp)
        muls.l  d3,d0
        bvs.s   .s_axis
        add.l   d2,d0
        bvs.s   .s_axis
        ble.s   .s_axis
        tst.l   d2
        ble.s   .s_axis
        cmp.l   #MOST,d0
        bhi.s   .s_axis
        cmp.l   #MOST,d2
        bhi.s   .s_axis
        move.l  d0,w_end(sp)
        cmpi.l  #FEW-1,left(sp)
        blt.s   .s_axis
        moveq   #8,d1
        cmp.l   d2,d0
        bhs.s   .rises
        bfffo   d2{0:0},d1
        move.l  d0,d3
        lsl.l   d1,d3
        move.l  d2,d4
        lsl.l   d1,d4
        clr.w   d4
        swap    d4
        swap    d3
        lsr.w   #3,d3
        beq.s   .s_axis
        divu.w  d3,d4
        cmp.w   #254,d4
        bhi.s   .s_axis
        moveq   #2,d1                   ; for the bits cut off both
        add.w   d4,d1
        exg     d0,d2
.rises  move.l  d0,w_most(sp)
        move.l  d2,w_least(sp)
        mulu.w  d1,d1
        move.l  d1,fall(sp)
.s_axis move.l  (a0),s(sp)
        move.l  glide_steps_s(a2),ds(sp)
        moveq   #0,d0
        move.w  glide_steps_last_s(a2),d0
.axis   addq.w  #1,d0                   ; 0xffff becomes 2^32 - 1
        subq.l  #1,d0
        movea.l d0,a5
        move.l  left(sp),d4
        lea     4(a1,d4.l*4),a3         ; end
        movem.l s(sp),d0-d3
        tst.l   w_end(sp)
        beq     .each
        move.l  d0,d5
        magnitude d5
        move.l  d5,d6
        lsr.l   #1,d6
        cmp.l   d2,d6
        bhs     .each
        muls.l  d1,d4
        bvs     .each
        add.l   d0,d4
        bvs     .each
        movea.l d4,a6
        magnitude d4
        lsr.l   #1,d4
        cmp.l   w_end(sp),d4
        bhs     .each
        unclamp
        tst.l   w_most(sp)
        beq     .sound
        ; By differences.
        move.l  d2,d4
        movea.l d0,a6
        quotient
        move.l  d5,first_u(sp)
        move.l  d6,first_r(sp)
        add.l   d1,d0
        add.l   d3,d2
        move.l  d2,d4
        movea.l d0,a6
        move.l  d0,d5
        magnitude d5
        quotient
        move.l  d6,d0                   ; r
        sub.l   first_r(sp),d6
        move.l  d6,d1                   ; e
        move.l  d5,d4                   ; u
        sub.l   first_u(sp),d5          ; g
        ; The largest possible gg, from g + 2, at the first pixel and at the least w
        move.l  d3,d6
        magnitude d6
        add.l   d6,d6
        move.l  d5,d7
        magnitude d7
        addq.l  #2,d7
        mulu.l  d7,d6
        bvs     .again
        move.l  #LIMIT,d7
        sub.l   w_most(sp),d7
        cmp.l   d7,d6
        bhi     .again
        lsr.l   #6,d6
        addq.l  #1,d6
        mulu.l  fall(sp),d6
        bvs     .again
        move.l  #LIMIT,d7
        sub.l   w_least(sp),d7
        cmp.l   d7,d6
        bhi     .again
        lsr.l   #2,d6
        cmp.l   w_least(sp),d6
        bhi     .again
        move.l  d5,d6
        add.l   d6,d6
        muls.l  d3,d6                   ; gg
        sub.l   d6,d1
        move.l  first_u(sp),d7
        put     d7
        move.l  d4,d7
        put     d7
        move.l  a5,d7
        addq.l  #1,d7
        bne     .clamped
.wrapped
        step    .wrong,.right
        move.w  d4,(a1)
        addq.l  #4,a1
        cmpa.l  a3,a1
        bne.s   .wrapped
        bra     .next
        correct .wrong,.right
.clamped
        step    .bad,.good
        cmp.l   a5,d4
        bhi.s   .outside
        move.w  d4,(a1)
.wrote  addq.l  #4,a1
        cmpa.l  a3,a1
        bne.s   .clamped
        bra     .next
.outside
        tst.l   d4
        bmi.s   .low
        move.w  a5,(a1)
        bra.s   .wrote
.low    clr.w   (a1)
        bra.s   .wrote
        correct .bad,.good

        ; Pixel by pixel, all quotients sound.
.again  movem.l s(sp),d0-d3
.sound  dividends
        move.l  a5,d0
        addq.l  #1,d0
        bne.s   .sound_clamped
        move.l  left(sp),d0
        not.w   d0
        and.w   #3,d0                   ; pixels the first round lacks
        move.w  d0,d7
        lsl.w   #2,d7
        add.w   d7,d0
        jmp     .fours(pc,d0.w*4)
.fours  rept    4
        sound_quotient                  ; 20 bytes
        move.w  d0,(a1)
        addq.l  #4,a1
        endr
        cmpa.l  a3,a1
        bne.s   .fours
        bra     .next
.sound_clamped
        sound_quotient
        put     d0
        cmpa.l  a3,a1
        bne.s   .sound_clamped
        bra     .next

        ; Pixel by pixel.
.each   moveq   #30,d7
        sub.w   glide_steps_shift(a2),d7
.pixel  move.l  d2,d4
        ble     .odd
        move.l  d0,d5
        movea.l d0,a6
.known  magnitude d5
        move.l  d5,d6
        lsr.l   #1,d6
        cmp.l   d4,d6
        bhs     .cut
        quotient
.write  put     d5
        add.l   d1,d0
        add.l   d3,d2
        cmpa.l  a3,a1
        bne.s   .pixel
.next   subq.w  #1,axis(sp)
        bmi.s   .done
        lea     2(a3),a1                ; t, after the last pixel
        move.l  left(sp),d0
        lsl.l   #2,d0
        suba.l  d0,a1
        subq.l  #4,a1
        move.l  glide_iterators_t(a0),s(sp)
        move.l  glide_steps_t(a2),ds(sp)
        moveq   #30,d7
        sub.w   glide_steps_shift(a2),d7
        moveq   #0,d0
        move.w  glide_steps_last_t(a2),d0
        bra     .axis
.done   lea     locals(sp),sp
        return_all

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
