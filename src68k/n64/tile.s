        include "routine.i"

; n64_tile - coordinates relative to a tile
;
; in:      a0  const n64_coordinates*  coordinates
;          a1  n64_coordinates*  relative coordinates; may be the same memory
;          a2  const n64_axes*  the tile's axes
; formats: s:t, both s10.5; the results modulo 2^16
; cost:    bench rows n64_tile, n64_tile_plain

; Both axes at once if they only have an origin; otherwise one at a time, by a loop that does only
; what the axis needs.

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
        move.w  n64_axis_range_clamp(a2),d1
        or.w    n64_axis_range_shift(a2),d1
        or.w    T+n64_axis_range_clamp(a2),d1
        or.w    T+n64_axis_range_shift(a2),d1
        bne.s   .axes
        lea     (a0,d0.l*4),a3
        move.w  T+n64_axis_range_low(a2),d1
        move.w  n64_axis_range_low(a2),d2
        swap    d2
        clr.w   d2
.moved  move.l  (a0)+,d0
        sub.w   d1,d0
        sub.l   d2,d0
        move.l  d0,(a1)+
        cmpa.l  a3,a0
        bne.s   .moved
        movem.l (sp)+,d2-d7/a2-a4
        rts

.axes
        move.l  d0,d6
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
