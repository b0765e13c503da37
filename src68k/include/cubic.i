; Perspective spans that draw each line from its far end to the near one by cubics.
;
; On a line u = K + U, U = C / q. A piece begins with its exact U; t pixels on U / (1 + x), x = t dq / q, is
; U (1 + p1 x + p2 x^2 + p3 x^3). Its differences are multiplied up from r = 2^(30 + bits) / q, and step u and v.
;
; \1: right if q grows to the right, or left.

        include "far.i"

; On the stack; ku to cv where far.i has them.
cubic_from_q    equ     4               ; the next piece's q
cubic_line_end  equ     8
cubic_dq        equ     12
cubic_top       equ     16              ; of 2^(30 + bits), two longs
cubic_shift     equ     48              ; and 32 less it
cubic_factor1   equ     56
cubic_factor2   equ     60
cubic_factor3   equ     64
cubic_most      equ     68              ; words: lambda / dq, 16.16
cubic_longest   equ     70              ; pixels less one
cubic_dcu_low   equ     72              ; below dcu
cubic_dcv_low   equ     76
cubic_cu_low    equ     80
cubic_cv_low    equ     84
cubic_bytes     equ     88

PIXEL   equ     28                      ; bytes of its code

; \1 = C\2 r / 2^shift; d1: r, d4: shift, d5: 32 less it. Uses d0.
cubic_value macro
        move.l  d1,\1
        muls.l  far_c\2(sp),d0:\1
        lsl.l   d5,d0
        lsr.l   d4,\1
        or.l    d0,\1
        endm

; d4 = \1 d0 / 2^24: 8.24 from 16.16 and 0.32. Uses d5.
cubic_first macro
        move.l  \1,d5
        muls.l  d0,d4:d5
        lsl.l   #8,d4
        rol.l   #8,d5
        move.b  d5,d4
        endm

; \1 = the first difference, from its first term there, the second one \2 and the third one \3:d1, which gives 6 of
; it, cut. \4: a temporary; an address register costs a branch. Uses d1/a6.
cubic_differences macro
        adda.l  \2,\1
        adda.l  \3,\1
        move.l  \3,\4
        movea.l d1,a6
        add.l   d1,d1
        addx.l  \3,\3
        add.l   a6,d1
        ifc     '\4','a5'
        bcc.s   .whole\@
        addq.l  #1,\3
.whole\@
        add.l   a5,\3
        else
        addx.l  \4,\3
        endc
        add.l   d1,d1
        addx.l  \3,\3
        add.l   \2,\2
        add.l   \3,\2
        endm

; Draws the texel at u, v = d0, d1, 8.24; d5: $00ffffff. Uses d4.
cubic_texel macro
        move.l  d0,d4
        lsr.l   #8,d4
        eor.l   d1,d4
        and.l   d5,d4
        eor.l   d1,d4                   ; VUuu
        swap    d4
        ifc     '\1','right'
        move.b  (a4,d4.w),(a1)+
        else
        move.b  (a4,d4.w),-(a1)
        endc
        endm

; Steps C\1 to the next line. Uses d0-d2.
cubic_next macro
        move.l  cubic_dc\1_low(sp),d0
        move.l  far_dc\1(sp),d1
        move.l  far_c\1(sp),d2
        add.l   d0,cubic_c\1_low(sp)
        addx.l  d1,d2
        move.l  d2,far_c\1(sp)
        endm

; Draws the table of the span in a0.
cubic_lines macro
        lea     -cubic_bytes(sp),sp
        far_table
        movem.l cubic_span_ku(a0),d0-d7/a1-a4           ; to top
        bchg    #31,d1                  ; see the map
        movem.l d0-d5,far_ku(sp)
        movem.l d6-d7/a1-a4,cubic_shift(sp)             ; to most
        movem.l cubic_span_dcu_low(a0),d0-d3            ; dcv_low, dq, top
        movem.l d0-d1,cubic_dcu_low(sp)
        movem.l d2-d3,cubic_dq(sp)
        clr.l   cubic_top+4(sp)
        clr.l   cubic_cu_low(sp)
        clr.l   cubic_cv_low(sp)
        movea.l cubic_span_map(a0),a4
        adda.l  #32768,a4               ; the index is signed: K of v is 128 rows on
        movea.l cubic_span_lines(a0),a0
        bra.s   .line

.below  cmpa.l  far_end(sp),a0
        beq     .done
        cubic_next u
        cubic_next v
.line   movem.l (a0)+,d6/a1/a6
        far_is_empty \1,.below
        move.l  a6,cubic_line_end(sp)

        ; d6 q  d7 pixels less one  d1 r  d2 U  d3 V
.piece  move.l  d6,d7
        swap    d7
        mulu.w  cubic_most(sp),d7
        swap    d7
        cmp.w   cubic_longest(sp),d7
        bls.s   .long
        move.w  cubic_longest(sp),d7
.long   move.w  cubic_line_end+2(sp),d0
        sub.w   a1,d0
        ifc     '\1','left'
        neg.w   d0
        endc
        subq.w  #1,d0
        cmp.w   d0,d7
        bhs.s   .ends
        move.w  d7,d0
        beq.s   .inside                 ; one pixel
        addq.w  #1,d0
        ext.l   d0
        mulu.l  cubic_dq(sp),d0
        add.l   d6,d0
        move.l  d0,cubic_from_q(sp)     ; of the next piece
        bra.s   .inside
.ends   move.w  d0,d7
.inside
        movem.l cubic_top(sp),d0-d1
        divu.l  d6,d0:d1
        movem.l cubic_shift(sp),d4-d5
        cubic_value d2,u
        cubic_value d3,v
        tst.w   d7
        beq     .single

        ; the terms: a2, d5, d6 of u  a3, d0, d4 of v
        move.l  d1,d4
        muls.l  cubic_factor1(sp),d0:d4
        cubic_first d2
        movea.l d4,a2
        cubic_first d3
        movea.l d4,a3
        move.l  d1,d4
        muls.l  cubic_factor2(sp),d0:d4
        move.l  a2,d4
        muls.l  d0,d5:d4
        move.l  a3,d4
        muls.l  d0,d0:d4
        muls.l  cubic_factor3(sp),d4:d1
        move.l  d5,d1
        muls.l  d4,d6:d1
        cubic_differences a2,d5,d6,a5
        movea.l d6,a5
        move.l  d0,d1
        muls.l  d4,d4:d1
        cubic_differences a3,d0,d4,d6
        movea.l d4,a6
        move.l  d0,d4
        lsl.l   #8,d2
        lsl.l   #8,d3
        move.l  d2,d0
        move.l  d3,d1
        add.l   far_ku(sp),d0
        add.l   far_kv(sp),d1
        move.l  a2,d2
        move.l  a3,d3
        movea.l d5,a2
        movea.l d4,a3
        move.l  #$ffffff,d5

        ; d0, d1 u, v, 8.24  d2, d3 first differences  a2, a3 second  a5, a6 third
        moveq   #3,d4
        and.w   d7,d4
        lsr.w   #2,d7
        move.w  .entries(pc,d4.w*2),d4
        jmp     .entries(pc,d4.w)
.entries
        dc.w    .pixels-.entries+3*PIXEL,.pixels-.entries+2*PIXEL
        dc.w    .pixels-.entries+PIXEL,.pixels-.entries

        cnop    0,4
.pixels rept    4
        cubic_texel \1
        add.l   d2,d0
        add.l   a2,d2
        adda.l  a5,a2
        add.l   d3,d1
        add.l   a3,d3
        adda.l  a6,a3
        endr
        dbra    d7,.pixels
        move.l  cubic_from_q(sp),d6
        cmpa.l  cubic_line_end(sp),a1
        bne     .piece
        bra     .below

.single lsl.l   #8,d2
        lsl.l   #8,d3
        move.l  d2,d0
        move.l  d3,d1
        add.l   far_ku(sp),d0
        add.l   far_kv(sp),d1
        move.l  #$ffffff,d5
        cubic_texel \1
        add.l   cubic_dq(sp),d6
        cmpa.l  cubic_line_end(sp),a1
        bne     .piece
        bra     .below

.done   lea     cubic_bytes(sp),sp
        rts
        endm
