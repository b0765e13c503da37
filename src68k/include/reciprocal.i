; Perspective spans by a table of reciprocals: linear pieces of 2^\1 pixels.
;
; The circular chain of two registers (see span/affine_addx.s), all bytes in use:
;       B  uuVv         A  vvuU
; The carry out of u's last byte in A goes up into vv, a unit of 2^-24 of v, and V's
; overflow enters u's lowest bit. A's v is a step ahead, except at a piece's last pixel:
; its addx.w does not step v, so that the next piece's steps take over there.

        include "chain.i"

; On the stack.
reciprocal_next equ     0               ; line
reciprocal_row  equ     4
reciprocal_pitch equ    8
reciprocal_left equ     12              ; lines

reciprocal_pixel macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        addx.l  d2,d0
        addx.\1 d3,d1
        draw
        endm

; Draws the table of the span in a0.
reciprocal_pieces macro
        save_all
        move.l  reciprocal_span_count(a0),-(sp)
        move.l  reciprocal_span_pitch(a0),-(sp)
        move.l  reciprocal_span_row(a0),-(sp)
        subq.l  #4,sp
        move.l  reciprocal_span_map(a0),d4      ; mm00
        movea.l reciprocal_span_table(a0),a3
        movea.l reciprocal_span_lines(a0),a0
        movea.l #-$10000,a6

        ; a0 line, then its carry  a1 pixel  a4 step of q  a5 r where the piece begins
        ; d5 q  d6 Cu  d7 pieces left:Cv
.line   move.l  (a0)+,d7                ; left:n
        tst.w   d7
        bmi     .empty
        movea.l reciprocal_row(sp),a1
        swap    d7
        adda.w  d7,a1
        clr.w   d7
        lsr.l   #\1,d7
        movem.l (a0)+,d2-d3/d5/a4
        move.w  (a0)+,d6
        move.w  (a0)+,d7
        movea.w (a0)+,a5
        addq.l  #2,a0
        movea.w (a0)+,a2
        addq.l  #2,a0
        move.l  a0,(sp)
        movea.l a2,a0
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        move.l  d2,d0
        move.w  d3,d0                   ; uuVv
        move.l  d3,d1
        clr.w   d1
        move.b  d2,d1                   ; vv-U
        bra     .pixels_end

.piece  add.l   a4,d5
        moveq   #0,d2
        addx.w  d2,d5
        move.w  (a3,d5.w*2),d2
        move.w  d2,d3
        sub.w   a5,d2
        movea.w d3,a5
        move.w  d2,d3
        muls.w  d6,d2                   ; Uuuu
        muls.w  d7,d3                   ; Vvvv
        add.l   a0,d2
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        move.w  d3,d4
        clr.w   d3
        add.l   d3,d1                   ; a step ahead; X is its carry
        move.w  d2,d3                   ; vvuU
        move.w  d4,d2                   ; uuVv
        rept    (1<<\1)-1
        reciprocal_pixel l
        endr
.last   reciprocal_pixel w
.pixels_end
        add.l   a6,d7
        bpl     .piece

        swap    d7
        addq.w  #1,d7
        bne.s   .next                   ; the last piece is drawn

        ; The last piece is shorter; it ends at the line's last pixel.
        movea.l (sp),a2
        moveq   #(1<<\1)-1,d5
        and.w   reciprocal_line_n-reciprocal_line_sizeof(a2),d5
        move.w  reciprocal_line_last-reciprocal_line_sizeof(a2),d2
        sub.w   a5,d2
        move.w  d2,d3
        muls.w  d6,d2
        swap    d7
        muls.w  d7,d3
        move.l  .parts(pc,d5.w*4),d6
        muls.l  d6,d7:d2
        muls.l  d6,d6:d3
        lsl.l   #\1+1,d7
        lsl.l   #\1+1,d6
        add.l   a0,d7
        rol.l   #8,d7                   ; uuuU
        swap    d6                      ; vvVv
        move.l  d7,d2
        move.w  d6,d2                   ; uuVv
        clr.w   d6
        move.l  d6,d3
        move.w  d7,d3                   ; vvuU
        neg.w   d5
        lea     .last(pc,d5.w*8),a2
        lea     (a2,d5.w*4),a2
        moveq   #-1,d7
        add.l   d6,d1
        jmp     (a2)

.empty  lea     reciprocal_line_sizeof-4(a0),a0
        bra.s   .below
.next   movea.l (sp),a0
.below  move.l  reciprocal_pitch(sp),d7
        add.l   d7,reciprocal_row(sp)
        subq.l  #1,reciprocal_left(sp)
        bne     .line
        lea     16(sp),sp
        return_all

        ; 2^31 / steps
        cnop    0,4
.parts  dc.l    0
        rept    (1<<\1)-1
        dc.l    $7fffffff/(REPTN+1)
        endr
        endm
