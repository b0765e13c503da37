; Spans whose texels of 0 are transparent.

        include "span.i"

; Draws the texel at d4 unless it is 0, as pixel \1 of a round. MOVE keeps X. Uses d6. 8 bytes.
draw_keyed macro
        movea.l d4,a2
        move.b  (a2),d6
        beq.s   .clear\1
        move.b  d6,(a1)+
.drawn\1
        endm

; What pixel \1 of a round does if its texel is 0. ADDQ to an address register keeps X.
pass_keyed macro
.clear\1
        addq.l  #1,a1
        bra.s   .drawn\1
        endm

; Opens a span whose texels are in one row, up to the start of each line in d0, which a4 is to be added to.
keyed_row_line macro
        alone_open dudx
        pack_alone d2,d5,a4
        move.l  (sp),d3
        lea     .pixels_end-12(pc),a3
        span_line d0,d1
        span_rounds 3
        move.w  d0,d4                   ; mmVv
        move.b  d1,d5
        move.w  d5,d0                   ; uu-U
        endm

; The next texel of a row. 4 bytes.
row_next macro
        move.b  d0,d4                   ; mmVU
        addx.l  \1,d0
        endm

; The eight pixels of a round: \1 \2,\3 steps. Short branches reach the first ones' passes before them, the last ones'
; behind the loop over lines.
keyed_round macro
        pass_keyed 0
        pass_keyed 1
        pass_keyed 2
        pass_keyed 3
.pixels
        \1      \2,\3
        draw_keyed 0
        \1      \2,\3
        draw_keyed 1
        \1      \2,\3
        draw_keyed 2
        \1      \2,\3
        draw_keyed 3
        \1      \2,\3
        draw_keyed 4
        \1      \2,\3
        draw_keyed 5
        \1      \2,\3
        draw_keyed 6
        \1      \2,\3
        draw_keyed 7
        endm

keyed_passes macro
        pass_keyed 4
        pass_keyed 5
        pass_keyed 6
        pass_keyed 7
        endm
