; Lines with perspective by linear pieces, with texels and pixels of \1 = 1, 2 or 4 bytes.

        include "span.i"

; On the stack.
numerator equ   0                       ; of the piece's end
d_numerator equ 4                       ; a piece
weight  equ     8
d_weight equ    12
steps   equ     16                      ; left to the last pixel
grid    equ     20                      ; -pixels of a piece
piece   equ     24                      ; log2 of them
row     equ     28
pitch   equ     32
lines   equ     36                      ; left
rounds  equ     40                      ; of 8 pixels a piece, less one
locals  equ     44

; a4, d3, d2 = S, Q, P of the steps d2, d6 of u and v.
pack_steps macro
        ror.l   #8,d6                   ; v..Vv
        move.l  d6,d3
        and.l   #$ff000000,d3
        swap    d2                      ; uuUU
        move.b  d2,d3                   ; v--U
        clr.w   d2                      ; uu--
        movea.l d2,a4
        move.l  d6,d2
        endm

; Draws the table of the span in a0. S, Q and P of texel_next_apart continue from piece to piece; only their steps
; change.
perspective_lines_by_pieces macro
        save_all
        moveq   #0,d0
        move.l  perspective_span_longest(a0),d1
        subq.l  #3,d1
        bset    d1,d0
        subq.l  #1,d0
        move.l  d0,-(sp)
        move.l  perspective_span_count(a0),-(sp)
        move.l  perspective_span_pitch(a0),-(sp)
        move.l  perspective_span_row(a0),-(sp)
        moveq   #-1,d0
        move.l  perspective_span_longest(a0),d1
        lsl.l   d1,d0
        movem.l d0-d1,-(sp)
        lea     -grid(sp),sp
        ifeq    \1-1
        move.l  perspective_span_map(a0),d4
        lea     .pixels_end-14(pc),a3
        else
        movea.l perspective_span_map(a0),a3
        endc
        movea.l perspective_span_lines(a0),a0

        ; a0 line  a1 pixel  a5, a6 u, v where the piece begins
.line   move.w  perspective_line_n(a0),d7
        bmi     .next
        ext.l   d7
        move.l  d7,steps(sp)
        movea.l row(sp),a1
        moveq   #0,d1
        move.w  perspective_line_left(a0),d1
        lea     (a1,d1.l*\1),a1
        move.l  grid(sp),d2
        move.l  perspective_line_u(a0),d5
        and.l   d2,d5
        movea.l d5,a5
        and.l   perspective_line_v(a0),d2
        movea.l d2,a6
        pack_uv d5,d2,d1
        move.l  d2,d0                   ; d5 S, d1 Q, d0 P
        move.l  piece(sp),d7
        move.l  perspective_line_half(a0),d3
        lsl.l   d7,d3
        clr.l   numerator(sp)
        move.l  d3,d_numerator(sp)
        move.l  perspective_line_weight(a0),weight(sp)
        move.l  perspective_line_dweight(a0),d3
        lsl.l   d7,d3
        move.l  d3,d_weight(sp)

.piece  move.l  steps(sp),d7
        add.l   grid(sp),d7
        ble     .rest
        move.l  d7,steps(sp)
        movem.l (sp),d2-d3/d6-d7
        add.l   d3,d2
        add.l   d7,d6
        move.l  d2,numerator(sp)
        move.l  d6,weight(sp)
        moveq   #0,d7
        divu.l  d6,d2:d7                ; part: below 2^31
        move.l  perspective_line_du(a0),d3
        muls.l  d7,d6:d3
        move.l  perspective_line_dv(a0),d3
        muls.l  d7,d2:d3
        move.l  grid(sp),d3
        add.l   d6,d6
        add.l   perspective_line_u(a0),d6
        and.l   d3,d6
        add.l   d2,d2
        add.l   perspective_line_v(a0),d2
        and.l   d2,d3
        move.l  piece(sp),d7
        move.l  d6,d2
        sub.l   a5,d2
        movea.l d6,a5
        asr.l   d7,d2                   ; u a pixel
        move.l  d3,d6
        sub.l   a6,d6
        movea.l d3,a6
        asr.l   d7,d6                   ; v
        pack_steps
        move.w  rounds+2(sp),d7
.pixels rept    8
        texel_next_apart d2,d3
        ifeq    \1-1
        draw
        else
        draw_wide \1
        endc
        endr
.pixels_end
        dbra    d7,.pixels
        tst.l   steps(sp)
        bne     .piece

.next   lea     perspective_line_sizeof(a0),a0
        move.l  pitch(sp),d7
        add.l   d7,row(sp)
        subq.l  #1,lines(sp)
        bne     .line
        lea     locals(sp),sp
        return_all

        ; The last piece, and the line's last pixel.
.rest   move.l  steps(sp),d7
        clr.l   steps(sp)
        moveq   #0,d2
        moveq   #0,d6
        tst.l   d7
        beq.s   .one
        move.l  perspective_line_u(a0),d2
        add.l   perspective_line_du(a0),d2
        sub.l   a5,d2
        divs.l  d7,d2
        move.l  perspective_line_v(a0),d6
        add.l   perspective_line_dv(a0),d6
        sub.l   a6,d6
        divs.l  d7,d6
.one    pack_steps
        ifeq    \1-1
        span_rounds 3
        span_enter 2,4
        else
        span_rounds_out 3
        span_enter_out 2,4
        endc
        endm
