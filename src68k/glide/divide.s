        include "divide.i"

; glide_divide - a level's coordinates with perspective
;
; in:      a0  const glide_iterators*  at the first pixel
;          a1  glide_coordinates*  coordinates
;          a2  const glide_steps*  their steps, the level
; formats: 14.18 and 2.30 modulo 2^32 to s:t: q = s * 2^30 / w rounded down, clamped to 32 bits, 0
;          if w is 0, or negative and behind is 1; (q >> shift) - half, clamped to 0 to last_s, or
;          modulo 2^16 if that is 0xffff
; cost:    bench rows glide_divide, glide_divide_clamp, glide_divide_each

; A line is done part by part. A part is as long as its quotients are not clamped, and w is from 1 to 2^30.
;
; With n = s * 2^(30 - shift) the coordinate is u = n / w rounded down; r is the remainder. Two pixels are
; divided; from then on u grows by g, and r by e, its change if u grows by g, for both axes at once:
;       u += g    r += e    w += dw
;       while r is outside 0 to w - 1:    u += 1    r -= w    (or the other way), and
;               if 2 e > w, g + 1 is nearer to the slope:    g += 1    gg += 2 dw    e -= w
;               else    e -= dw
;       e -= gg             where gg = 2 g dw
; All modulo 2^32. That is exact as long as r, before its correction, is from -1.5 to 2.5 * 2^30. Let w be
; a pixel's, w' the next one's.
; - After the loop |e| <= w + |dw|. If r stayed inside, e is the difference of two remainders. Else let k
;   be r - e, which is the last remainder at first. e -= w leaves it. e -= dw needs r >= w and 2 e <= w, so
;   k >= w / 2, and leaves less than 0: it happens once. So e ends as such a difference, or between
;   -w / 2 - |dw| and w / 2 + |dw|. The other way is alike.
; - Then |e| <= w + |dw| + gg, and r, before its correction, exceeds neither -(w + |dw| + gg) nor that + w.
; - The slope, the growth of n / w, differs from g by (w + 2 |dw| + gg) / w' at most: below 1.19 + |g| / 8 if
;   |dw| <= w' / 16. So |g| <= (slope + 1.19) 8 / 7. Slopes are a constant over w w': from the first one,
;   which is below |first g| + 1, they grow by f at most; f is 1 or, if w falls, (first w / w')^2.
; - With A = 2 |dw| (|first g| + 3) f, then, gg <= 8 / 7 A. A + w' / 2 is greatest at an end. Where it is up to
;   LIMIT there, w + |dw| + gg <= 9 / 8 w' + 8 / 7 A < w' / 2 + w' / 16 + 8 / 7 LIMIT < 1.5 * 2^30. Nor does
;   w' + 2 e pass -2^31.
; A is above 8 w only where dividing is faster.
;
; Steep parts are divided from their third pixel on. s + 2 w is above 0 and below 4 w, 2^32 at most: times
; 2^(30 - shift) its quotient, u + 2^(31 - shift), fits.
;
; No quotient of a part is clamped if |u| is below 2^(31 - shift): it grows by (|first g| + 3) f a pixel at
; most. If an axis is clamped, |u| is kept below SMALL, so that 16 bits show what is outside; the part is
; clamped afterwards, unless both its ends are inside: u only rises or only falls. Where u of a whole map
; needs more than 16 bits, it is divided as the others below.
;
; Others are divided and tested one by one, axis by axis. Pixels with w below 0 are filled if behind is 1.

FEW     equ     5                       ; pixels: shorter parts are not done by differences
SHORT   equ     24                      ; a gentler part of a steep one is not shorter
TRIED   equ     16                      ; pixels that are done before other ways are tried again
MOST    equ     $40000000               ; w
LIMIT   equ     $34000000               ; A + w / 2
SMALL   equ     $4000                   ; |u| where an axis is clamped

s       equ     glide_iterators_s
t       equ     glide_iterators_t
w       equ     glide_iterators_w
ds      equ     glide_steps_s
dt      equ     glide_steps_t
dw      equ     glide_steps_w

; On the stack.
own     equ     0                       ; the iterators at a further part's first pixel
from    equ     12                      ; those in use
level   equ     16                      ; the steps
left    equ     20                      ; pixels
bits    equ     24                      ; 30 - shift
reach   equ     28                      ; |u| must be below
part    equ     32                      ; pixels
sound   equ     36                      ; pixels in reach, if they are not all gentle; or 0
w_end   equ     40                      ; of the part's last pixel
mask    equ     44                      ; 2^bits - 1
last    equ     48                      ; part - 1
axis    equ     52
locals  equ     56

        pass    glide_divide
        save_all
        lea     -locals(sp),sp
        move.l  d0,left(sp)
        move.l  a2,level(sp)
        moveq   #30,d7
        sub.w   glide_steps_shift(a2),d7
        move.l  d7,bits(sp)
        moveq   #2,d1
        lsl.l   d7,d1
        moveq   #-1,d2
        cmp.l   glide_steps_last_s(a2),d2       ; and last_t
        beq.s   .wraps
        cmp.w   #16,d7
        bhi     .divide
        cmp.l   #SMALL,d1
        bls.s   .wraps
        move.l  #SMALL,d1
.wraps  move.l  d1,reach(sp)

.begin  move.l  w(a0),d2
        ble     .behind
        moveq   #FEW,d1
        cmp.l   d1,d0
        blt     .divide
        cmp.l   #MOST,d2
        bhi     .unlike
.shorter
        move.l  d0,part(sp)
        subq.l  #1,d0
        muls.l  dw(a2),d0
        bvs     .half
        add.l   d2,d0
        ble     .half
        cmp.l   #MOST,d0
        bhi     .half
        move.l  d0,w_end(sp)
        clr.l   sound(sp)
        move.l  bits(sp),d7
        moveq   #32,d6
        sub.l   d7,d6
        movem.l (a0),d0-d1
        quotient d0,d3
        quotient d1,d4
        movea.l d0,a3
        movea.l d1,a4
        movea.l d3,a5
        movea.l d4,a6
        moveq   #0,d5
        move.w  glide_steps_half(a2),d5
        packed  (a1)
        movem.l (a0),d0-d1
        add.l   ds(a2),d0
        bvs     .unlike
        add.l   dt(a2),d1
        bvs     .unlike
        add.l   dw(a2),d2
        quotient d0,d3
        quotient d1,d4
        suba.l  d0,a3                   ; -g of s
        suba.l  d1,a4                   ; of t
        move.l  d0,d6
        magnitude d6
        move.l  d1,d7
        magnitude d7
        or.l    d7,d6                   ; no less than both |u|
        packed  4(a1)
        move.l  a3,d7
        magnitude d7
        move.l  a4,d1
        magnitude d1
        cmp.l   d1,d7
        bhs.s   .larger
        move.l  d1,d7
.larger addq.l  #3,d7                   ; |g| + 3
        cmp.l   reach(sp),d6
        bhs     .unlike
.judge  move.l  dw(a2),d1
        bmi     .falls
        move.l  part(sp),d5
        mulu.l  d7,d5
        bvs     .nearer
        add.l   d6,d5
        cmp.l   reach(sp),d5
        bhs     .nearer
        add.l   d1,d1
        mulu.l  d1,d7                   ; A
        bvs     .steep
        lsl.l   #3,d1
        cmp.l   w(a0),d1
        bhi     .steep
        move.l  d7,d5
        lsr.l   #3,d5
        cmp.l   w(a0),d5
        bhi     .steep
        move.l  w_end(sp),d5
        lsr.l   #1,d5
        add.l   d5,d7
        bcs     .steep
        cmp.l   #LIMIT,d7
        bhi     .steep

        ; By differences.
.gentle move.l  d2,d1
        move.l  d3,d2                   ; r of s
        sub.l   a5,d3                   ; e
        move.l  a3,d5
        neg.l   d5
        move.l  d5,d7
        swap    d7
        clr.w   d7
        movea.l d7,a3
        move.l  a4,d7
        neg.l   d7
        movea.l d7,a4
        exg     d4,d5
        move.l  d5,d6                   ; r of t
        sub.l   a6,d6                   ; e
        move.l  a0,from(sp)
        movea.l dw(a2),a0
        muls.l  dw(a2),d4
        muls.l  dw(a2),d7
        add.l   d4,d4
        add.l   d7,d7
        sub.l   d4,d3
        sub.l   d7,d6
        movea.l #$10000,a6
        movea.l part(sp),a5
        lea     (a1,a5.l*4),a2
        addq.l  #8,a1
        bra.s   .pixel
        wrong   .s_wrong,.s_right,d2,d3,d4,<add.l a6,d0>,<sub.l a6,d0>,<adda.l a6,a3>,<suba.l a6,a3>
.pixel  add.l   a0,d1
        add.l   a3,d0
        add.w   a4,d0
        step    d2,d3,d4,.s_wrong,.s_right
        step    d5,d6,d7,.t_wrong,.t_right
        move.l  d0,(a1)+
        cmpa.l  a2,a1
        bne.s   .pixel
.drawn  movea.l level(sp),a2
        movea.l from(sp),a0
        moveq   #-1,d1
        cmp.l   glide_steps_last_s(a2),d1       ; and last_t
        bne     .clamps
.next   move.l  part(sp),d0
        sub.l   d0,left(sp)
        bne.s   .further
        lea     locals(sp),sp
        return_all
        wrong   .t_wrong,.t_right,d5,d6,d7,<addq.w #1,d0>,<subq.w #1,d0>,<addq.l #1,a4>,<subq.l #1,a4>

.further
        movem.l (a0),d1-d3
        movem.l (a2),d4-d6
        muls.l  d0,d4
        muls.l  d0,d5
        muls.l  d0,d6
        add.l   d4,d1
        add.l   d5,d2
        add.l   d6,d3
        lea     own(sp),a0
        movem.l d1-d3,(a0)
        move.l  left(sp),d0
        bra     .begin

        judge_falling

.sooner move.l  part(sp),d5
        tst.l   sound(sp)
        bne.s   .again
        move.l  d5,sound(sp)
.again  lsr.l   #1,d5
        moveq   #SHORT,d1
        cmp.l   d1,d5
        bge.s   .fewer
        move.l  sound(sp),part(sp)
        bra.s   .exact

.nearer move.l  part(sp),d5
        lsr.l   #1,d5
        moveq   #FEW,d1
        cmp.l   d1,d5
        blt     .unlike
.fewer  move.l  d5,part(sp)
        subq.l  #1,d5
        muls.l  dw(a2),d5
        add.l   w(a0),d5
        move.l  d5,w_end(sp)
        bra     .judge

        ; Steep, but w rises: what follows a half may be gentle.
.steep  move.l  part(sp),d5
        lsr.l   #1,d5
        moveq   #SHORT,d1
        cmp.l   d1,d5
        blt.s   .exact
        move.l  d5,part(sp)
        divide_steep

        ; Each quotient tested.
.half   move.l  part(sp),d0
        lsr.l   #1,d0
        moveq   #FEW,d1
        cmp.l   d1,d0
        bge     .shorter
.unlike moveq   #TRIED,d0
        cmp.l   left(sp),d0
        blt.s   .divide
        move.l  left(sp),d0

        divide_tested
        fill_behind
        clamp_part
