        include "routine.i"

; \4 = travel of v by step \1 over half the box, from \2 to \3, 8.8, rounded up; a
; step of 256 texels or more goes to .may_wrap. d4 = 0 after it.
travel  macro
        move.l  texturing_\1(a0),\4
        bpl.s   .\1
        neg.l   \4
.\1    lsr.l   #8,\4
        swap    \4
        tst.w   \4
        bne     .may_wrap
        swap    \4
        addq.l  #1,\4
        move.l  rectangle_\3(a1),d4
        sub.l   rectangle_\2(a1),d4
        addq.l  #1,d4
        lsr.l   #1,d4
        mulu.l  d4,\4
        moveq   #0,d4
        endm

; texturing_wrap - how a polygon's spans deal with wraps of v in the addx chain
;
; in:      a0  texturing*  v (at the box's middle, except for CHAIN_ANYWHERE), its steps
;          a1  rectangle*  the pixels that the polygon may cover
;          d0  int32       enum chain
; reads:   v, dvdx, dvdy; the rectangle
; writes:  wraps, wrap_bit; u_cut if u's lowest bit is kept free
; formats: a wrap of v in a span carries into the lowest bit of u. There is none if v
;          stays between two multiples of 256 all over the box, or shares no chain with
;          u. One wrap is caught by keeping that bit free (u_cut 1), with wrap_bit in it: 1
;          if v falls. If there may be more, or u keeps all bits (CHAIN_WHOLE), wraps is
;          1
; error:   none: in doubt it assumes a wrap
; cost:    about 190 cycles, 170 to 380; less without a chain
        routine texturing_wrap,a0,a1,d0
        movem.l d2-d5,-(sp)
        moveq   #0,d2                   ; u_cut
        moveq   #0,d3                   ; wraps
        moveq   #0,d4                   ; wrap_bit
        move.l  d0,d5
        beq     .done
        subq.l  #CHAIN_ANYWHERE,d0
        beq     .may_wrap

        ; from the box's middle to its farthest corner
        travel  dvdx,left,right,d0
        travel  dvdy,top,bottom,d1
        add.l   d1,d0
        addq.l  #1,d0
        move.l  texturing_v(a0),d1
        lsr.l   #8,d1
        and.l   #$ffff,d1
        cmp.l   d0,d1
        blo.s   .may_wrap
        add.l   d0,d1
        swap    d1
        tst.w   d1
        beq     .done

.may_wrap
        subq.l  #CHAIN_WHOLE,d5
        beq.s   .wraps
        move.l  texturing_dvdx(a0),d0
        lsl.l   #8,d0                   ; as the chain steps it: modulo 256 texels
        bpl.s   .speed
        moveq   #1,d4
        neg.l   d0
.speed  clr.w   d0
        swap    d0                      ; 8.8, cut
        addq.l  #1,d0
        move.l  rectangle_right(a1),d1
        sub.l   rectangle_left(a1),d1
        mulu.l  d1,d0
        cmp.l   #$10000,d0
        bhi.s   .wraps
        moveq   #1,d2
        bra.s   .done
.wraps  moveq   #1,d3
        moveq   #0,d4
.done   or.l    d2,texturing_u_cut(a0)
        move.l  d3,texturing_wraps(a0)
        move.l  d4,texturing_wrap_bit(a0)
        movem.l (sp)+,d2-d5
        rts
