; Perspective spans that draw each line from its far end to the near one: pieces of 2^\1 pixels.
;
; On a line u = K + C r with r = table[q]: K and the step of q are the polygon's, C is the line's and grows by
; the same on each. From the far end on, q only grows, so the last piece is an ordinary one that the line's end
; cuts short: what is behind it is no nearer to the horizon. The chain of two registers as in reciprocal.i.
;
; \3: the bits that C lacks, 0 or 4: if K is far away, C has more bits than a word. Then starts take it whole,
; as rounding it would move the line; steps take the word, as r grows less.

        include "chain.i"

; On the stack.
far_end         equ     0               ; of the table
far_row         equ     4               ; the line's, at pixel -EDGE_BIAS
far_pitch       equ     8
far_q           equ     12              ; at pixel -EDGE_BIAS of the line
far_dqdx        equ     16
far_dqdy        equ     20
far_ku          equ     24
far_kv          equ     28
far_dcu         equ     32
far_dcv         equ     36
far_bytes       equ     40

; \1: l, or w at a piece's last pixel; \2: left or right, the way that lines are drawn.
far_pixel macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        addx.l  d2,d0
        addx.\1 d3,d1
        movea.l d4,a2
        ifc     '\2','right'
        move.b  (a2),(a1)+
        else
        move.b  (a2),-(a1)
        endc
        endm

; The steps d2, d3 for the chain; v is a step ahead, and X is its carry. Uses d4.
far_steps macro
        move.w  d3,d4
        clr.w   d3
        add.l   d3,d1
        move.w  d2,d3                   ; vvuU
        move.w  d4,d2                   ; uuVv
        endm

; d2, d3 = u and v, 8.24, where r is d2.
far_start macro
        ifeq    \2
        move.w  d2,d3
        muls.w  d6,d2                   ; Uuuu
        muls.w  d7,d3                   ; Vvvv
        lsl.l   #\1,d2
        lsl.l   #\1,d3
        else
        ext.l   d2
        move.l  d7,d3
        far_product \1+\2
        movea.l d3,a2
        move.l  d6,d3
        far_product \1+\2
        move.l  d3,d2
        move.l  a2,d3
        endc
        add.l   far_ku(sp),d2
        add.l   far_kv(sp),d3
        endm

; d3 = C, fraction:integer and rounded, times d2, times 2^\1. Uses d0.
far_product macro
        swap    d3
        sub.l   #$8000,d3
        muls.l  d2,d0:d3                ; 32.16
        lsr.l   #8,d3
        ifne    16-8-(\1)
        lsr.l   #16-8-(\1),d3
        endc
        swap    d0
        clr.w   d0
        lsl.l   #\1,d0
        or.l    d0,d3
        endm

; Draws the table of the span in a0; \2: right if q grows to the right, or left.
far_pieces macro
        move.l  far_span_count(a0),d0
        movea.l far_span_lines(a0),a1
        lsl.l   #2,d0
        lea     (a1,d0.l),a2
        lea     (a2,d0.l*2),a2
        lea     -far_bytes(sp),sp
        move.l  a2,far_end(sp)
        move.l  far_span_row(a0),far_row(sp)
        move.l  far_span_pitch(a0),far_pitch(sp)
        movem.l far_span_q(a0),d0-d3    ; dqdx, dqdy, dq
        movem.l d0-d2,far_q(sp)
        movea.l d3,a4
        movem.l far_span_ku(a0),d0-d3/d6-d7     ; kv, dcu, dcv, cu, cv
        movem.l d0-d3,far_ku(sp)
        move.l  far_span_map(a0),d4     ; mm00
        movea.l far_span_table(a0),a3
        movea.l a1,a0

        ; a0 line  a1 pixel  a6 the line's end  a4 step of q  a5 r where the piece begins
        ; d5 q  d6 Cu  d7 Cv
.line   move.l  (a0)+,d0                ; start0:left
        move.w  (a0)+,d1                ; last
        addq.l  #6,a0
        movea.l far_row(sp),a2
        move.w  d1,d2
        sub.w   d0,d2
        bmi     .below
        addq.w  #1,d2
        moveq   #0,d5
        ifc     '\2','right'
        move.w  d0,d5
        lea     (a2,d5.l),a1
        else
        move.w  d1,d5
        lea     1(a2,d5.l),a1
        neg.w   d2
        endc
        lea     (a1,d2.w),a6
        muls.l  far_dqdx(sp),d5
        add.l   far_q(sp),d5
        swap    d5
        move.w  (a3,d5.w*2),d2
        movea.w d2,a5
        far_start \1,\3
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        move.l  d2,d0
        move.w  d3,d0                   ; uuVv
        move.l  d3,d1
        clr.w   d1
        move.b  d2,d1                   ; vv-U

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
        ifne    \3
        lsl.l   #\3,d2
        lsl.l   #\3,d3
        endc
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        ifc     '\2','right'
        move.w  a1,d4
        sub.w   a6,d4
        else
        move.w  a6,d4
        sub.w   a1,d4
        endc
        cmp.w   #-(1<<\1),d4
        bge     .last
        far_steps
        rept    (1<<\1)-1
        far_pixel l,\2
        endr
        far_pixel w,\2
.pixels_end
        cmpa.l  a6,a1
        bne     .piece

.below  move.l  far_pitch(sp),d0
        add.l   d0,far_row(sp)
        move.l  far_dqdy(sp),d0
        add.l   d0,far_q(sp)
        moveq   #0,d2
        add.l   far_dcu(sp),d6
        addx.w  d2,d6
        add.l   far_dcv(sp),d7
        addx.w  d2,d7
        cmpa.l  far_end(sp),a0
        bne     .line
        lea     far_bytes(sp),sp
        rts

.last   lea     .pixels_end(pc,d4.w*4),a2
        lea     (a2,d4.w*8),a2          ; 12 bytes a pixel
        far_steps
        jmp     (a2)
        endm
