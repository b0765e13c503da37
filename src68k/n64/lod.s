        include "n64.i"

; n64_lod - coordinates with perspective, and the blending of tiles at each pixel
;
; like:    n64_divide
; in:      a2  const n64_lod_steps*  their steps, gradients, tables, the other output
; writes:  the coordinates, a n64_blending of each pixel; behind the last blending, N64_NO_TILES
; formats: coordinates as n64_divide; the steps are the gradients in x. Gradients are cut to
;          multiples of 2^5 in x and of 2^15 in y
; cost:    bench rows n64_lod, n64_lod_apart

; Divides the pixel and its neighbours in x and in y. n64_guard shows lines where no quotient of
; them is clamped. There the neighbour in x becomes the next pixel: what its cut gradients lack, 0
; to 31 of each, is added by add.w, and the pixel is divided again only if that carries into an
; upper word.

; On the stack.
iterators equ   0
in_x    equ     12
in_y    equ     24
left    equ     36
rest    equ     40                      ; words: what the gradients in x lack
last    equ     48                      ; the end of the coordinates
locals  equ     52

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
; away.
neighbour macro
        movem.l iterators(sp),d0-d2
        add.l   \1(sp),d0
        add.l   \1+4(sp),d1
        add.l   \1+8(sp),d2
        bsr     .divide
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

; \3:\1 = s and \4:\2 = t at d0, d1, without their fractions, times the reciprocal d3: \3, \4 are
; the quotients. \5: adds this gradient on the stack to s and t, if given.
quotients macro
        move.l  d0,\1
        ifnb    \5
        add.l   \5(sp),\1
        endc
        clr.w   \1
        muls.l  d3,\3:\1
        move.l  d1,\2
        ifnb    \5
        add.l   \5+4(sp),\2
        endc
        clr.w   \2
        muls.l  d3,\4:\2
        endm

; Writes the blending of the change d7, below $4000. Uses d3-d5.
blending macro
        cmp.w   #N64_NEAR_LEVELS,d7
        bhs     \1
        move.l  (a6,d7.w*4),(a0)+
        endm
coarse  macro
        move.w  d7,d3
        lsr.w   #5,d3
        move.l  n64_levels_levels(a6,d3.w*4),d4 ; tiles, shift, 255 if only one tile is used
        move.w  d4,d5
        lsr.w   #8,d5
        lsl.l   #3,d7
        lsr.l   d5,d7
        or.b    d4,d7
        and.w   #255,d7
        move.w  d7,d4
        move.l  d4,(a0)+
        endm

        pass    n64_lod
        save_all
        lea     -locals(sp),sp
        move.l  d0,left(sp)
        moveq   #~31,d4
        cut     n64_lod_steps_s,in_x
        move.l  #~$7fff,d4
        cut     n64_lod_steps_y_s,in_y
        movea.l n64_lod_steps_reciprocals(a2),a3
        movea.l n64_lod_steps_levels(a2),a6
        lea     (a1,d0.l*4),a4
        move.l  a4,last(sp)
        movem.l n64_lod_steps_y_s(a2),d4-d6
        movea.l d6,a4
        n64_magnitude d4,d5
        neg.l   d6                      ; w may fall by as much to the pixel below
        bvs     .slow
        ble.s   .rises
        add.l   d6,d4
        bvs     .slow
.rises  add.l   #N64_GUARD,d4
        bvs     .slow
        n64_guard .slow,add
        movem.l (a2),d4-d6
        moveq   #31,d3
        and.w   d3,d4
        and.w   d3,d5
        and.w   d3,d6
        move.w  d4,rest(sp)
        move.w  d5,rest+2(sp)
        move.w  d6,rest+4(sp)
        movem.l (a0),d0-d2
        movea.l n64_lod_steps_blendings(a2),a0
        movea.l last(sp),a2

.again  move.l  d2,d3
        swap    d3
        move.l  (a3,d3.w*4),d3
        quotients d4,d6,d5,d7
        movea.l d5,a4
        movea.l d7,a5
        cmpa.l  a2,a1
        beq     .done
.pixel  move.l  a4,d3
        swap    d3
        move.w  a5,d3
        move.l  d3,(a1)+
        move.l  in_y+8(sp),d3
        add.l   d2,d3
        swap    d3
        move.l  (a3,d3.w*4),d3
        quotients d4,d6,d5,d7,in_y
        sub.l   a5,d7
        minus   <not.l d7>
        distance d5,a4
        add.l   in_x(sp),d0
        add.l   in_x+4(sp),d1
        add.l   in_x+8(sp),d2
        move.l  d2,d3
        swap    d3
        move.l  (a3,d3.w*4),d3
        quotients d4,d4,d5,d6
        move.l  d5,d3
        distance d3,a4
        movea.l d5,a4
        move.l  d6,d3
        distance d3,a5
        movea.l d6,a5
        blending .coarse
.next   add.w   rest(sp),d0
        bcs.s   .s_more
        add.w   rest+2(sp),d1
        bcs.s   .t_more
        add.w   rest+4(sp),d2
        bcs.s   .w_more
        cmpa.l  a2,a1
        bne     .pixel
        bra     .done
.s_more add.l   #$10000,d0
        add.w   rest+2(sp),d1
        bcc.s   .t_done
.t_more add.l   #$10000,d1
.t_done add.w   rest+4(sp),d2
        bcc     .again
.w_more add.l   #$10000,d2
        bra     .again
.coarse cmp.w   #$4000,d7
        bhs.s   .most
        coarse
        bra.s   .next
.most   move.l  n64_levels_far(a6),(a0)+
        bra.s   .next

.slow   movem.l (a0),d1-d3
        movem.l d1-d3,iterators(sp)
        movea.l n64_lod_steps_blendings(a2),a0
        bra     .any

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

.far    move.l  n64_levels_far(a6),(a0)+
.step   movem.l (a2),d0-d2
        add.l   d0,iterators(sp)
        add.l   d1,iterators+4(sp)
        add.l   d2,iterators+8(sp)
        subq.l  #1,left(sp)
        beq     .done
.any    movem.l iterators(sp),d0-d2
        bsr.s   .divide
        movea.l d5,a4
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
        tst.w   d3
        bmi.s   .far
        moveq   #0,d7
        neighbour in_x
        neighbour in_y
        cmp.l   #$4000,d7
        bge     .far
        blending .other
        bra     .step
.other  coarse
        bra     .step
.far_s  n64_nearest d5
        bra   .s
.far_t  n64_nearest d6
        bra   .t
.done   move.w  #N64_NO_TILES,(a0)
        lea     locals(sp),sp
        return_all
