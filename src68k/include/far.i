; Perspective spans that draw each line from its far end to the near one.
;
; On a line u = K + C r with r = table[q]: K and the step of q are the polygon's, C is the line's and grows by
; the same on each. q is shifted left by b, which is even, so that its index is 2^13 to 2^15, C by as much; where
; that is over, b is 2 less, and the line begins again. Pieces have 16, 8, 4, 2 or 1 pixels, the fewer the faster q
; grows.
; From the far end on, q only grows, so the last piece is an ordinary one that the line's end cuts short: what
; is behind it is no nearer to the horizon. u and v are stepped by the chain of two registers of chain.i.
;
; \1: right if q grows to the right, or left.
; \2: the bits that C lacks, 0, 4 or 8: if K is far away, C has more bits than a word. Then starts take it whole,
; as rounding it would move the line; steps take the word, as r grows less.

        include "chain.i"

; On the stack.
far_end         equ     0               ; of the table
far_dq          equ     4               ; the step of q a pixel on
far_most_16     equ     8               ; of this in pieces of 16
far_most_8      equ     12
far_most_4      equ     16
far_most_2      equ     20
far_ku          equ     24
far_kv          equ     28
far_dcu         equ     32
far_dcv         equ     36
far_cu          equ     40              ; of the line, not shifted
far_cv          equ     44
far_shift       equ     48              ; b
far_bytes       equ     52

; Stores the end of the table of the span in a0, which is below everything on the stack. Uses d0/a1-a2.
far_table macro
        move.l  far_span_count(a0),d0
        movea.l far_span_lines(a0),a1
        lsl.l   #2,d0
        lea     (a1,d0.l),a2
        lea     (a2,d0.l*2),a2          ; 12 bytes a line
        move.l  a2,(sp)
        endm

; Branches to \2 if the line from a1 to a6 has no pixels.
far_is_empty macro
        cmpa.l  a1,a6
        ifc     '\1','right'
        bls.s   \2
        else
        bhs.s   \2
        endc
        endm

; Steps \1 on the stack by d\1 to the next line. Uses d0.
far_next macro
        move.l  far_d\1(sp),d0
        add.l   d0,far_\1(sp)
        endm

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

; \1 = \1, 16.16, rounded to a word in its lower half.
far_word macro
        add.l   #$8000,\1
        swap    \1
        endm

; \1 = \2, 16.16, which lacks \3 bits, times r in d2, 8.24. Uses d0.
far_whole macro
        move.l  \2,\1
        muls.l  d2,d0:\1
        move.b  d0,\1
        ror.l   #8,\1
        far_up  \3-4,\1
        endm

; \2 = \2 times 2^\1, \1 up to 16.
far_up  macro
        ifgt    (\1)-8
        lsl.l   #8,\2
        lsl.l   #(\1)-8,\2
        else
        ifne    \1
        lsl.l   #\1,\2
        endc
        endc
        endm

; d2, d3 = u and v, 8.24, where r is d2. d6, d7: Cu, Cv, words; or 16.16 if they are coarse, which become words.
far_start macro
        ifeq    \2
        move.w  d2,d3
        muls.w  d6,d2                   ; Uuuu
        muls.w  d7,d3                   ; Vvvv
        lsl.l   #4,d2
        lsl.l   #4,d3
        else
        ext.l   d2
        far_whole d1,d6,\2
        far_whole d3,d7,\2
        move.l  d1,d2
        far_word d6
        far_word d7
        endc
        add.l   far_ku(sp),d2
        add.l   far_kv(sp),d3
        endm

; d0, d1 = the chain's registers from d2, d3 = u and v, 8.24.
far_chain macro
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        move.l  d2,d0
        move.w  d3,d0                   ; uuVv
        move.l  d3,d1
        clr.w   d1
        move.b  d2,d1                   ; vv-U
        endm

; d2, d3 = the steps uuuU and vvVv of a piece of 2^\1 pixels whose last q has the index d5.
far_growth macro
        move.w  (a3,d5.w*2),d2
        move.w  d2,d3
        sub.w   a5,d2
        movea.w d3,a5
        move.w  d2,d3
        muls.w  d6,d2                   ; Uuuu
        muls.w  d7,d3                   ; Vvvv
        far_up  4-(\1)+\2,d2
        far_up  4-(\1)+\2,d3
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        endm

; d4 = what is left of the line, in pixels less than 0.
far_rest macro
        ifc     '\1','right'
        move.w  a1,d4
        sub.w   a6,d4
        else
        move.w  a6,d4
        sub.w   a1,d4
        endc
        endm

; Pieces of 2^\3 pixels; d3: step of q a pixel.
far_pieces macro
        ifne    \3
        lsl.l   #\3,d3
        endc
        swap    d3
        movea.l d3,a4
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
        tst.w   d5
        bmi     .piece\3
        cmpa.l  a6,a1
        bne     .over
        bra     .below

.last\3 moveq   #0,d5                   ; no further piece
        lea     .pixels\3(pc,d4.w*4),a2
        lea     (a2,d4.w*8),a2          ; 12 bytes a pixel
        far_steps
        jmp     (a2)
        endm

; Draws the table of the span in a0.
far_lines macro
        lea     -far_bytes(sp),sp
        far_table
        move.l  far_span_dq(a0),d0
        movea.l far_span_lengths(a0),a1
        movem.l (a1),d1-d4              ; most_16, 8, 4, 2
        movem.l d0-d4,far_dq(sp)
        movem.l far_span_ku(a0),d0-d5   ; kv, dcu, dcv, cu, cv
        movem.l d0-d5,far_ku(sp)
        move.l  far_span_map(a0),d4     ; mm00
        movea.l far_span_table(a0),a3
        movea.l far_span_lines(a0),a0
        bra.s   .line

        ; a0 line  a1 pixel  a6 the line's end  a4 step of q  a5 r where the piece begins
        ; d4 mm00  d5 q, its index less 2^15  d6 Cu  d7 Cv
.below  cmpa.l  far_end(sp),a0
        beq     .done
        far_next cu
        far_next cv
.line   movem.l (a0)+,d5/a1/a6
        far_is_empty \1,.below
        bfffo   d5{1:31},d2
        subq.l  #1,d2
        and.w   #-2,d2
        lsl.l   d2,d5
.begun  move.l  d2,far_shift(sp)
        move.l  far_dq(sp),d3
        move.l  far_cu(sp),d6
        move.l  far_cv(sp),d7
        lsl.l   d2,d3
        lsl.l   d2,d6
        lsl.l   d2,d7
        movea.l d3,a4
        bchg    #31,d5
        swap    d5
        move.w  (a3,d5.w*2),d2
        movea.w d2,a5
        ifeq    \2
        far_word d6
        far_word d7
        endc
        far_start \1,\2
        far_chain
        move.l  a4,d3
        cmp.l   far_most_16(sp),d3
        bhi     .under_16
        far_pieces \1,\2,4
.under_16
        cmp.l   far_most_8(sp),d3
        bhi     .under_8
        far_pieces \1,\2,3
.under_8
        cmp.l   far_most_4(sp),d3
        bhi     .under_4
        far_pieces \1,\2,2
.under_4
        cmp.l   far_most_2(sp),d3
        bhi     .under_2
        far_pieces \1,\2,1
.under_2
        far_pieces \1,\2,0

.over   swap    d5
        bchg    #31,d5
        lsr.l   #2,d5
        move.l  far_shift(sp),d2
        subq.l  #2,d2
        bra     .begun

.done   lea     far_bytes(sp),sp
        rts
        endm
