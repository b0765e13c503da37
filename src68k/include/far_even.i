; Perspective spans as in far.i for polygons whose q differ at most four times. q and C are shifted by one bit,
; so that the index is 2^13 to 2^15 on every line, and all pieces have the same length: a line only looks up
; its beginning.
;
; \1: right if q grows to the right, or left; \2: as in far.i.

        include "far.i"

; On the stack; ku and kv where far.i has them.
even_end        equ     0               ; of the table
even_row        equ     4               ; the line's, at pixel -EDGE_BIAS
even_pitch      equ     8
even_q          equ     12              ; at pixel -EDGE_BIAS of the line, less 2^31
even_dqdx       equ     16
even_dqdy       equ     20
even_cu         equ     24              ; of the line; if it is a word, half a unit more
even_cv         equ     28
even_dcu        equ     32
even_dcv        equ     36
even_pieces     equ     40              ; the loop over a line's pieces
even_bytes      equ     52
        ifne    far_ku-44
        fail    ku is not where far_start reads it
        endc

; Steps \1 to the next line. Uses d0.
even_next macro
        move.l  even_d\1(sp),d0
        add.l   d0,even_\1(sp)
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
        move.l  far_span_count(a0),d0
        movea.l far_span_lines(a0),a1
        lsl.l   #2,d0
        lea     (a1,d0.l),a2
        lea     (a2,d0.l*2),a2
        lea     -even_bytes(sp),sp
        move.l  a2,even_end(sp)
        move.l  far_span_row(a0),even_row(sp)
        move.l  far_span_pitch(a0),even_pitch(sp)
        movem.l far_span_q(a0),d0-d2    ; dqdx, dqdy
        add.l   d0,d0
        add.l   d1,d1
        add.l   d2,d2
        bchg    #31,d0
        movem.l d0-d2,even_q(sp)
        movem.l far_span_ku(a0),d0-d5   ; kv, dcu, dcv, cu, cv
        movem.l d0-d1,far_ku(sp)
        add.l   d2,d2
        add.l   d3,d3
        add.l   d4,d4
        add.l   d5,d5
        ifeq    \2
        add.l   #$8000,d4
        add.l   #$8000,d5
        endc
        movem.l d2-d3,even_dcu(sp)
        movem.l d4-d5,even_cu(sp)
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

        ; a0 line  a1 pixel  a6 the line's end  a4 step of q  a5 r where the piece begins
        ; d4 mm00  d5 q, its index less 2^15  d6 Cu  d7 Cv
.line   move.l  (a0)+,d0                ; start0:left
        move.w  (a0)+,d1                ; last
        addq.l  #6,a0
        move.w  d1,d2
        sub.w   d0,d2
        bmi     .below
        addq.w  #1,d2
        movea.l even_row(sp),a2
        moveq   #0,d5
        ifc     '\1','right'
        move.w  d0,d5
        lea     (a2,d5.l),a1
        else
        move.w  d1,d5
        lea     1(a2,d5.l),a1
        neg.w   d2
        endc
        lea     (a1,d2.w),a6
        muls.l  even_dqdx(sp),d5
        add.l   even_q(sp),d5
        swap    d5
        move.w  (a3,d5.w*2),d2
        movea.w d2,a5
        ifeq    \2
        move.w  even_cu(sp),d6
        move.w  even_cv(sp),d7
        else
        move.l  even_cu(sp),d6
        move.l  even_cv(sp),d7
        endc
        far_start \1,\2
        far_chain
        movea.l even_pieces(sp),a2
        jmp     (a2)
        even_loop \1,\2,4
        even_loop \1,\2,3
        even_loop \1,\2,2

.below  move.l  even_pitch(sp),d0
        add.l   d0,even_row(sp)
        move.l  even_dqdy(sp),d0
        add.l   d0,even_q(sp)
        even_next cu
        even_next cv
        cmpa.l  even_end(sp),a0
        bne     .line
        lea     even_bytes(sp),sp
        rts
        endm
