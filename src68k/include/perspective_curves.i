; Lines with perspective by curved pieces, with texels and pixels of \1 = 1, 2 or 4 bytes: of 1, map
; rows from 128 on are behind the others, else before them.

        include "chain.i"

; On the stack.
now_u   equ     0                       ; of the next pixel, 16.16
now_v   equ     4
numerator equ   8                       ; its k * half
mid_u   equ     12
mid_v   equ     16
row     equ     20
frame   equ     24                      ; perspective_span*
lines   equ     28                      ; left
locals equ 32

; \3, \4 = u, v of the pixel whose numerator is \1 and weight \2: data registers, all
; different. Uses d0; \1 and \2 are lost.
point   macro
        moveq   #0,d0
        divu.l  \2,\1:d0                ; part: below 2^31
        move.l  perspective_line_du(a0),\4
        muls.l  d0,\3:\4
        move.l  perspective_line_dv(a0),\1
        muls.l  d0,\4:\1
        add.l   \3,\3
        add.l   perspective_line_u(a0),\3
        add.l   \4,\4
        add.l   perspective_line_v(a0),\4
        endm

; Draws the pixel of \3 bytes at u, v (\1, \2). Uses both.
single  macro
        swap    \1
        lsr.l   #8,\2
        move.b  \1,\2
        ifeq    \3-1
        bchg    #15,\2
        endc
        texel   \2,\3
        endm

; Draws the texel \1 of \2 bytes.
texel   macro
        ifeq    \2-1
        move.b  (a4,\1.w),(a1)+
        endc
        ifeq    \2-2
        move.w  (a4,\1.w*2),(a1)+
        endc
        ifeq    \2-4
        move.l  (a4,\1.w*4),(a1)+
        endc
        endm

; The curve through \1 (where it begins), \2 and \3 (d registers), d7 = log2 of their
; distance: \2 = second difference a pixel, \3 = the first step. Uses d4-d5; a5 =
; distance^2 / 2.
bend    macro
        sub.l   \2,\3
        sub.l   \1,\2                   ; to the middle, \3 from there
        move.l  \2,d4
        sub.l   \2,\3
        move.l  \3,\2
        add.l   a5,\2
        asr.l   d7,\2
        asr.l   d7,\2
        asr.l   d7,d4
        move.l  \2,\3
        lsl.l   d7,\3
        sub.l   \2,\3
        asr.l   #1,\3
        sub.l   \3,d4
        move.l  d4,\3
        endm

; Draws the table of the span in a0.
perspective_lines_by_curves macro
        save_all
        move.l  perspective_span_count(a0),-(sp)
        move.l  a0,-(sp)
        move.l  perspective_span_row(a0),-(sp)
        lea     -row(sp),sp
        movea.l perspective_span_map(a0),a4
        ifeq    \1-1
        adda.l  #32768,a4               ; the index is signed: v starts 128 rows on
        endc
        movea.l perspective_span_lines(a0),a0

        ; a0 line  a1 pixel  a4 map  a6 k: steps left to the last pixel
        ; d6 the next pixel's weight  d7 log2 of half the piece tried first
.line   move.w  perspective_line_n(a0),d0
        bmi     .next
        movea.w d0,a6
        movea.l row(sp),a1
        moveq   #0,d1
        move.w  perspective_line_left(a0),d1
        lea     (a1,d1.l*\1),a1
        movem.l perspective_line_u(a0),d1-d2
        movem.l d1-d2,now_u(sp)
        tst.w   d0
        beq     .last
        clr.l   numerator(sp)
        move.l  perspective_line_weight(a0),d6
        movea.l frame(sp),a2
        move.l  perspective_span_longest(a2),d7
        subq.l  #1,d7

        ; The longest piece whose weights are enough.
.piece  move.l  a6,d5
        lea     perspective_line_enough4-4(a0),a5
.try    tst.w   d7
        beq     .alone
        moveq   #2,d4
        lsl.l   d7,d4                   ; its length
        move.l  perspective_line_dweight(a0),d3
        move.l  d6,d2
        cmp.l   d5,d4
        bhi.s   .past_end
        cmp.l   (a5,d7.w*4),d2
        blt.s   .shorter
        lsl.l   d7,d3
        add.l   d3,d2                   ; in its middle
        add.l   d2,d3                   ; and after it
        cmp.l   (a5,d7.w*4),d3
        bge     .found
.shorter
        subq.w  #1,d7
        bra.s   .try

        ; It would end after the line: it begins earlier if the line is long enough.
.past_end
        move.w  perspective_line_n(a0),d1
        ext.l   d1
        cmp.l   d1,d4
        bhi.s   .shorter
        sub.l   d5,d4                   ; steps back
        move.l  d4,d1
        muls.l  d3,d1
        sub.l   d1,d2
        cmp.l   (a5,d7.w*4),d2
        blt.s   .shorter
        lsl.l   d7,d3
        move.l  d2,d1
        add.l   d3,d2
        add.l   d2,d3
        cmp.l   (a5,d7.w*4),d3
        blt.s   .shorter
        rept    \1
        suba.l  d4,a1                   ; back
        endr
        adda.l  d4,a6
        move.l  perspective_line_half(a0),d5
        mulu.l  d5,d4
        move.l  numerator(sp),d5
        sub.l   d4,d5
        move.l  d5,numerator(sp)
        move.l  d1,d6
        tst.l   d5
        beq.s   .begins                 ; with the line
        movea.l d2,a2
        movea.l d3,a3
        point   d5,d1,d2,d3
        movem.l d2-d3,now_u(sp)
        move.l  a2,d2
        move.l  a3,d3
        bra.s   .found
.begins move.l  perspective_line_u(a0),now_u(sp)
        move.l  perspective_line_v(a0),now_v(sp)

        ; d2 weight in the middle  d3 after the piece
.found  move.l  perspective_line_half(a0),d4
        lsl.l   d7,d4
        add.l   numerator(sp),d4
        movea.l d3,a5
        move.l  d4,d1
        point   d4,d2,d3,d5
        movem.l d3/d5,mid_u(sp)
        move.l  perspective_line_half(a0),d4
        lsl.l   d7,d4
        add.l   d4,d1
        move.l  d1,numerator(sp)
        moveq   #2,d0
        lsl.l   d7,d0
        suba.l  d0,a6
        move.l  a6,d0
        beq.s   .ends
        move.l  a5,d6
        move.l  a5,d2
        point   d1,d2,d3,d5
        bra.s   .three
.ends   movem.l perspective_line_u(a0),d3/d5
        add.l   perspective_line_du(a0),d3
        add.l   perspective_line_dv(a0),d5

        ; Three points: now, mid, d3 and d5.
.three  moveq   #1,d4
        lsl.l   d7,d4
        lsl.l   d7,d4
        lsr.l   #1,d4
        movea.l d4,a5
        move.l  now_u(sp),d0
        move.l  now_v(sp),d1
        movem.l d3/d5,now_u(sp)
        move.l  mid_u(sp),d2
        bend    d0,d2,d3
        movea.l d2,a2
        exg     d3,d5                   ; d5 step of u
        move.l  mid_v(sp),d2
        bend    d1,d2,d3
        lsl.l   #8,d2
        movea.l d2,a3
        lsl.l   #8,d3
        lsl.l   #8,d1
        ifeq    \1-1
        bchg    #31,d1
        endc
        move.l  d5,d2
        move.l  #$ffffff,d5
        movea.l d7,a5
        subq.w  #1,d7                   ; 4, 8, 16, 32 pixels: 1, 2, 4, 8 rounds
        moveq   #1,d4
        lsl.w   d7,d4
        move.w  d4,d7
        subq.w  #1,d7
.pixels rept    4
        join_uv d5
        add.l   d2,d0
        add.l   a2,d2
        add.l   d3,d1
        add.l   a3,d3
        texel   d4,\1
        endr
        dbra    d7,.pixels
        move.l  a5,d7
        move.l  a6,d0
        beq.s   .last
.longer addq.w  #1,d7
        movea.l frame(sp),a2
        cmp.w   perspective_span_longest+2(a2),d7
        blo     .piece
        subq.w  #1,d7
        bra     .piece

        ; A single pixel.
.alone  move.l  now_u(sp),d1
        move.l  now_v(sp),d2
        single  d1,d2,\1
        subq.l  #1,a6
        move.l  a6,d0
        beq.s   .line_ends
        move.l  numerator(sp),d1
        add.l   perspective_line_half(a0),d1
        move.l  d1,numerator(sp)
        add.l   perspective_line_dweight(a0),d6
        move.l  d6,d2
        point   d1,d2,d3,d4
        movem.l d3-d4,now_u(sp)
        bra.s   .longer
.line_ends
        movem.l perspective_line_u(a0),d1-d2
        add.l   perspective_line_du(a0),d1
        add.l   perspective_line_dv(a0),d2
        movem.l d1-d2,now_u(sp)
.last   move.l  now_u(sp),d1
        move.l  now_v(sp),d2
        single  d1,d2,\1

.next   lea     perspective_line_sizeof(a0),a0
        movea.l frame(sp),a2
        move.l  perspective_span_pitch(a2),d0
        add.l   d0,row(sp)
        subq.l  #1,lines(sp)
        bne     .line
        lea     locals(sp),sp
        return_all
        endm
