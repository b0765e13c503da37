        include "routine.i"

; n64_tile - coordinates relative to a tile
;
; in:      a0  const n64_coordinates*  coordinates
;          a1  n64_coordinates*  relative coordinates; may be the same memory
;          a2  const n64_axes*  the tile's axes
; formats: s:t, both s10.5; the results modulo 2^16
; cost:    bench rows n64_tile, n64_tile_plain, n64_tile_clamp

; Both axes at once if none has a shift: by two subtractions, or with a look at what they clamp.
; Otherwise one at a time, by a loop that does only what the axis needs.

; With x a coordinate, y = x - low and a range high - low that is not negative, x is inside if none
; of x, y and (high - low - 1) - y is negative; where x is not, nothing overflows. Both axes' signs
; are looked at together. t may borrow 1 from s in the last one, so that s is looked at once more.

; \1: the instruction that shifts d0 by d1, if any.
axis_loops macro
        tst.w   n64_axis_range_clamp(a2)
        bne.s   .clamped\@
.plain\@
        move.w  (a3),d0
        addq.l  #4,a3
        \1
        sub.w   d2,d0
        move.w  d0,(a4)
        addq.l  #4,a4
        dbra    d7,.plain\@
        rts
.over\@ move.w  d4,(a4)
        addq.l  #4,a4
        dbra    d7,.clamped\@
        rts
.below\@
        clr.w   (a4)
        addq.l  #4,a4
        dbra    d7,.clamped\@
        rts
.clamped\@
        move.w  (a3),d0
        addq.l  #4,a3
        \1
        cmp.w   d3,d0
        bge.s   .over\@
        sub.w   d2,d0
        blt.s   .below\@
        move.w  d0,(a4)
        addq.l  #4,a4
        dbra    d7,.clamped\@
        rts
        endm

T       equ     n64_axes_t

        pass    n64_tile
        movem.l d2-d7/a2-a4,-(sp)
        move.w  n64_axis_range_shift(a2),d1
        or.w    T+n64_axis_range_shift(a2),d1
        bne     .axes
        lea     (a0,d0.l*4),a3
        move.w  T+n64_axis_range_low(a2),d3
        move.w  n64_axis_range_low(a2),d2
        swap    d2
        clr.w   d2
        moveq   #0,d6                   ; the signs of the axes that clamp
        tst.w   n64_axis_range_clamp(a2)
        beq.s   .any_s
        move.w  #$8000,d6
        swap    d6
.any_s  tst.w   T+n64_axis_range_clamp(a2)
        beq.s   .any_t
        move.w  #$8000,d6
.any_t  tst.l   d6
        beq.s   .moved
        move.w  n64_axis_range_high(a2),d5
        sub.w   n64_axis_range_low(a2),d5
        subq.w  #1,d5
        swap    d5
        move.w  T+n64_axis_range_high(a2),d5
        sub.w   d3,d5
        subq.w  #1,d5
        move.l  d5,d1
        and.l   d6,d1
        bne     .axes                   ; a range is negative
.pair   move.l  (a0)+,d0                ; x
        move.l  d0,d1
        sub.w   d3,d0
        sub.l   d2,d0                   ; y
        move.l  d5,d4
        or.l    d0,d1
        sub.l   d0,d4
        or.l    d4,d1
        and.l   d6,d1
        bne.s   .out
.in     move.l  d0,(a1)+
        cmpa.l  a3,a0
        bne.s   .pair
.done   movem.l (sp)+,d2-d7/a2-a4
        rts

.moved  move.l  (a0)+,d0
        sub.w   d3,d0
        sub.l   d2,d0
        move.l  d0,(a1)+
        cmpa.l  a3,a0
        bne.s   .moved
        bra.s   .done

.out    tst.w   d1
        bpl.s   .t_in
        move.w  -2(a0),d4
        clr.w   d0
        cmp.w   T+n64_axis_range_high(a2),d4
        blt.s   .t_in
        move.w  T+n64_axis_range_last(a2),d0
.t_in   tst.l   d1
        bpl.s   .in
        move.w  -4(a0),d4
        cmp.w   n64_axis_range_high(a2),d4
        bge.s   .over_s
        cmp.w   n64_axis_range_low(a2),d4
        bge.s   .in
        swap    d0
        clr.w   d0
        swap    d0
        bra.s   .in
.over_s swap    d0
        move.w  n64_axis_range_last(a2),d0
        swap    d0
        bra.s   .in

.axes   move.l  d0,d6
        bsr.s   .axis
        addq.l  #2,a0
        addq.l  #2,a1
        lea     n64_axis_range_sizeof(a2),a2
        bsr.s   .axis
        movem.l (sp)+,d2-d7/a2-a4
        rts

.axis   movea.l a0,a3
        movea.l a1,a4
        move.w  d6,d7
        subq.w  #1,d7
        move.w  n64_axis_range_low(a2),d2
        move.w  n64_axis_range_high(a2),d3
        move.w  n64_axis_range_last(a2),d4
        move.w  n64_axis_range_shift(a2),d1
        bgt.s   .right
        blt     .left
        axis_loops
.right  axis_loops <asr.w d1,d0>
.left   neg.w   d1
        axis_loops <lsl.w d1,d0>
