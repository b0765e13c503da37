; Perspective spans as in far.i for polygons whose q differ at most four times. q and C are shifted by one bit,
; so that the index is 2^13 to 2^15 on every line, and all pieces have the same length: a line only looks up
; its beginning.
;
; \1: right if q grows to the right, or left; \2: as in far.i.

        include "far.i"

; On the stack; ku and kv where far.i has them.
even_end        equ     0               ; of the table
even_pieces     equ     4               ; the loop over a line's pieces
even_cu         equ     8               ; of the line, if C is coarse
even_cv         equ     12
even_ku         equ     far_ku
even_dcu        equ     far_ku+8        ; swapped, unless C is coarse
even_dcv        equ     far_ku+12
even_bytes      equ     far_ku+16
        ifgt    even_cv+4-far_ku
        fail    C is where far_start reads K
        endc

; Steps C to the next line. Uses d0/d2.
even_next macro
        ifeq    \1
        moveq   #0,d2
        add.l   even_dcu(sp),d6
        addx.w  d2,d6
        add.l   even_dcv(sp),d7
        addx.w  d2,d7
        else
        far_next cu,even
        far_next cv,even
        endc
        endm

; The loop over pieces of 2^\3 pixels. In: a4 step of q a piece, swapped.
even_loop macro
.piece\3
        add.l   a4,d5
        moveq   #0,d2
        addx.w  d2,d5
        far_growth \3,\2
        far_rest \1
        cmp.w   #-(1<<\3),d4
        bge     .last\3
        far_steps
        rept    (1<<\3)-1
        far_pixel l,\1
        endr
        far_pixel w,\1
.pixels\3
        cmpa.l  a6,a1
        bne     .piece\3
        bra     .below

.last\3 lea     .pixels\3(pc,d4.w*4),a2
        lea     (a2,d4.w*8),a2          ; 12 bytes a pixel
        far_steps
        jmp     (a2)
        endm

; Draws the table of the span in a0.
even_lines macro
        lea     -even_bytes(sp),sp
        far_table
        movem.l far_span_ku(a0),d0-d3/d6-d7     ; kv, dcu, dcv, cu, cv
        add.l   d2,d2
        add.l   d3,d3
        add.l   d6,d6
        add.l   d7,d7
        ifeq    \2
        add.l   #$8000,d6
        add.l   #$8000,d7
        swap    d2
        swap    d3
        swap    d6
        swap    d7
        else
        movem.l d6-d7,even_cu(sp)
        endc
        movem.l d0-d3,even_ku(sp)
        move.l  far_span_dq(a0),d3
        move.l  far_span_even(a0),d0
        addq.l  #1,d0
        lsl.l   d0,d3
        swap    d3
        movea.l d3,a4                   ; step of q a piece
        lea     .piece4(pc),a2
        subq.l  #4,d0
        bgt.s   .chosen
        lea     .piece3(pc),a2
        beq.s   .chosen
        lea     .piece2(pc),a2
.chosen move.l  a2,even_pieces(sp)
        move.l  far_span_map(a0),d4     ; mm00
        movea.l far_span_table(a0),a3
        movea.l far_span_lines(a0),a0
        bra.s   .line

        ; a0 line  a1 pixel  a6 the line's end  a4 step of q  a5 r where the piece begins
        ; d4 mm00  d5 q, its index less 2^15  d6 Cu  d7 Cv
.below  cmpa.l  even_end(sp),a0
        beq.s   .done
        even_next \2
.line   movem.l (a0)+,d5/a1/a6
        far_is_empty \1,.below
        swap    d5
        move.w  (a3,d5.w*2),d2
        movea.w d2,a5
        ifne    \2
        move.l  even_cu(sp),d6
        move.l  even_cv(sp),d7
        endc
        far_start \1,\2
        far_chain
        movea.l even_pieces(sp),a2
        jmp     (a2)
.done   lea     even_bytes(sp),sp
        rts

        even_loop \1,\2,4
        even_loop \1,\2,3
        even_loop \1,\2,2
        endm
