; Perspective spans as in far.i for polygons whose q differ at most four times. q and C are shifted by one bit,
; so that the index is 2^13 to 2^15 on every line: a line begins once. Its pieces grow with q, from 4 or 8 pixels
; to 8 and 16. They end where q is a little greater, as a chord lags behind its curve.
;
; \1: right if q grows to the right, or left; \2: as in far.i.

        include "far.i"

; On the stack; ku and kv where far.i has them.
even_end        equ     0               ; of the table; a line without pixels is there
even_step2      equ     4               ; of q in pieces of 4 pixels, swapped
even_step3      equ     8               ; of 8
even_step4      equ     12              ; of 16
even_from3      equ     16              ; words: the index less 2^15 from which pieces have 8 pixels
even_from4      equ     18              ; and 16
even_table      equ     20              ; for starts
even_ku         equ     far_ku
even_dcu        equ     far_ku+8        ; swapped, unless C is coarse
even_dcv        equ     far_ku+12
even_cu         equ     far_ku+16       ; of the line, if C is coarse
even_cv         equ     far_ku+20
even_bytes      equ     far_ku+24
        ifgt    even_table+4-far_ku
        fail    something is where far_start reads K
        endc

; Steps C to the next line. Uses d2.
even_next macro
        ifeq    \1
        moveq   #0,d2
        add.l   even_dcu(sp),d6
        addx.w  d2,d6
        add.l   even_dcv(sp),d7
        addx.w  d2,d7
        else
        even_on cu,d6
        even_on cv,d7
        endc
        endm

; Steps \1, if C is coarse, which is \2 then.
even_on macro
        move.l  even_\1(sp),\2
        add.l   even_d\1(sp),\2
        move.l  \2,even_\1(sp)
        endm

; Stores d3, the step of q in pieces of 2^\1 pixels, and doubles it. Uses d0.
even_step macro
        move.l  d3,d0
        swap    d0
        move.l  d0,even_step\1(sp)
        add.l   d3,d3
        endm

; The loop over pieces of 2^\3 pixels, until those of 2^\4 may begin or the line ends.
even_loop macro
.from\3 movea.l even_step\3(sp),a4
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
        ifeq    \3-4
        bne     .piece\3
        bra     .below
        else
        beq     .below
        cmp.w   even_from\4(sp),d5
        blt     .piece\3
        bra     .from\4
        endc

.last\3 lea     .pixels\3(pc,d4.w*4),a2
        lea     (a2,d4.w*8),a2          ; 12 bytes a pixel
        far_steps
        jmp     (a2)
        endm

; Draws the table of the span in a0.
even_lines macro
        lea     -even_bytes(sp),sp
        far_table
        clr.l   far_line_from(a2)       ; so that the table's end is tested at empty lines alone
        clr.l   far_line_end(a2)
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
        lsl.l   #3,d3
        even_step 2
        even_step 3
        even_step 4
        move.l  far_span_from_8(a0),even_from3(sp)      ; from_16 too
        move.l  far_span_map(a0),d4     ; mm00
        move.l  far_span_table(a0),even_table(sp)
        movea.l far_span_ends(a0),a3
        movea.l far_span_lines(a0),a0
        bra     .line

        even_loop \1,\2,3,4

.empty  cmpa.l  even_end(sp),a0
        bls.s   .below
        lea     even_bytes(sp),sp
        rts

        ; a0 line  a1 pixel  a6 the line's end  a4 step of q  a5 r where the piece begins
        ; d4 mm00  d5 q, its index less 2^15  d6 Cu  d7 Cv
.below  even_next \2
.line   movem.l (a0)+,d5/a1/a6
        far_is_empty \1,.empty
        swap    d5
        movea.l even_table(sp),a2
        move.w  (a2,d5.w*2),d2
        movea.w d2,a5
        far_start \1,\2
        far_chain
        cmp.w   even_from4(sp),d5
        bge     .from4
        cmp.w   even_from3(sp),d5
        bge     .from3
        even_loop \1,\2,2,3
        even_loop \1,\2,4
        endm
