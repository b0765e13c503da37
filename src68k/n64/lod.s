        include "n64.i"

; n64_lod - coordinates with perspective, and the blending of tiles at each pixel
;
; like:    n64_divide
; in:      a2  const n64_lod_steps*  their steps, gradients, tables, the other output
; writes:  the coordinates, a n64_blending of each pixel
; formats: coordinates as n64_divide; the gradients are cut to multiples of 2^5 in x and of
;          2^15 in y
; cost:    bench rows n64_lod, n64_lod_apart

; Divides three points: the pixel's and those of its neighbours in x and in y. If the steps
; are the gradients, the neighbour in x is the next pixel and is divided only once.

; On the stack.
iterators equ   0
in_x    equ     12
in_y    equ     24
left    equ     36
kept    equ     40                      ; d3, d5, d6 of the point in x
is_kept equ     52
same    equ     54                      ; -1 if that point is the next pixel
locals  equ     56

LEVELS  equ     n64_levels_levels       ; a6 points there, after the magnified ones

; d7 = the larger of d7 and |\1 - \2|; of a negative difference it takes the one's complement.
distance macro
        sub.l   \2,\1
        minus   <not.l \1>
        cmp.l   d7,\1
        ble.s   .less\@
        move.l  \1,d7
.less\@
        endm

; Raises d7 to the change of the quotients from the pixel to its neighbour, the gradient \1
; away. \2: keeps the neighbour's quotients, if given.
neighbour macro
        movem.l iterators(sp),d0-d2
        add.l   \1(sp),d0
        add.l   \1+4(sp),d1
        add.l   \1+8(sp),d2
        bsr     .divide
        ifnb    \2
        movem.l d3/d5-d6,kept(sp)
        move.w  same(sp),is_kept(sp)
        endc
        tst.w   d3
        bmi     .far
        distance d5,a4
        distance d6,a5
        endm

; Copies the gradient \1 of a2's struct, cut by the mask d4, to \2 on the stack.
cut     macro
        movem.l \1(a2),d1-d3
        and.l   d4,d1
        and.l   d4,d2
        and.l   d4,d3
        movem.l d1-d3,\2(sp)
        endm

        pass    n64_lod
        save_all
        lea     -locals(sp),sp
        move.l  d0,left(sp)
        movem.l (a0),d1-d3
        movem.l d1-d3,iterators(sp)
        moveq   #~31,d4
        cut     n64_lod_steps_x_s,in_x
        moveq   #0,d0
        cmp.l   n64_lod_steps_s(a2),d1
        bne.s   .apart
        cmp.l   n64_lod_steps_t(a2),d2
        bne.s   .apart
        cmp.l   n64_lod_steps_w(a2),d3
        bne.s   .apart
        moveq   #-1,d0
.apart  move.l  d0,is_kept(sp)          ; and same
        clr.w   is_kept(sp)
        move.l  #~$7fff,d4
        cut     n64_lod_steps_y_s,in_y
        movea.l n64_lod_steps_reciprocals(a2),a3
        movea.l n64_lod_steps_blendings(a2),a0
        movea.l n64_lod_steps_levels(a2),a6
        lea     LEVELS(a6),a6
        bra     .pixels

        ; d5, d6 = s, t at the iterators d0-d2, d3 = -1 if one does not fit 17 bits
.divide move.l  d2,d3
        swap    d3
        subq.w  #1,d3
        ble.s   .small
        move.l  4(a3,d3.w*4),d3
        move.l  d0,d4
        clr.w   d4
        muls.l  d3,d5:d4
        move.l  d1,d4
        clr.w   d4
        muls.l  d3,d6:d4
.fit    moveq   #0,d3
        move.l  d5,d4
        add.l   #$10000,d4
        cmp.l   #$20000,d4
        bhs.s   .out
        move.l  d6,d4
        add.l   #$10000,d4
        cmp.l   #$20000,d4
        bhs.s   .out
        rts
.small  blt.s   .bad
        move.l  d0,d5                   ; w = 1: times 32,768
        clr.w   d5
        asr.l   #1,d5
        move.l  d1,d6
        clr.w   d6
        asr.l   #1,d6
        bra.s   .fit
.bad    move.l  #$7fffffff,d5
        move.l  d5,d6
.out    moveq   #-1,d3
        rts

.magnified
        move.l  n64_levels_magnified-LEVELS(a6,d7.w*4),(a0)+
        bra     .next
.far    move.l  n64_levels_far-LEVELS(a6),(a0)+
.next   movem.l (a2),d0-d2
        add.l   d0,iterators(sp)
        add.l   d1,iterators+4(sp)
        add.l   d2,iterators+8(sp)
        subq.l  #1,left(sp)
        beq     .done
.pixels tst.w   is_kept(sp)
        beq.s   .divided
        movem.l kept(sp),d3/d5-d6
        clr.w   is_kept(sp)
        bra.s   .here
.divided
        movem.l iterators(sp),d0-d2
        bsr     .divide
.here   movea.l d5,a4
        movea.l d6,a5
        movea.w d5,a6
        cmpa.l  d5,a6
        bne     .far_s
.s      movea.w d6,a6
        cmpa.l  d6,a6
        bne     .far_t
.t      swap    d5
        move.w  d6,d5
        move.l  d5,(a1)+
        movea.l n64_lod_steps_levels(a2),a6
        lea     LEVELS(a6),a6
        tst.w   d3
        bmi     .far
        moveq   #0,d7
        neighbour in_x,kept
        neighbour in_y
        cmp.l   #$4000,d7
        bge     .far
        move.w  d7,d3
        lsr.w   #5,d3
        beq     .magnified
        move.l  (a6,d3.w*4),d4          ; tiles, shift, 255 if only one tile is used
        move.w  d4,d5
        lsr.w   #8,d5
        lsl.l   #3,d7
        lsr.l   d5,d7
        or.b    d4,d7
        and.w   #255,d7
        move.w  d7,d4
        move.l  d4,(a0)+
        bra     .next
.far_s  n64_nearest d5
        bra     .s
.far_t  n64_nearest d6
        bra     .t
.done   lea     locals(sp),sp
        return_all
