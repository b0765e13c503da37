; Spans with dithered texture coordinates: (u, v) is offset by (x & 1, y & 1), the pixel's
; position in the frame.
;
; The offsets of (u, v) in eighths of a texel:
;       (2, 0)  (6, 2)          in even lines, for even x and for odd x
;       (0, 4)  (4, 6)          in odd lines
; Starts are 3/8 less than the pixels' own. So in all lines the step from a pixel with even x is
; (4, 2) more than without dithering, and from one with odd x (4, 2) less.

        include "span.i"

; On the stack, for all lines: four longwords, the offsets as uu:Vv, in the order of 2 x + y.
DITHER_LAST     equ     16+2            ; a word: odd if a round begins with the step of even x
DITHER_PITCH    equ     20
DITHER_END      equ     24              ; of the table
DITHER_BYTES    equ     28

; Opens a dithered span: fills the stack; a6 = row, d4 = map's page, d2 and d5 = steps of u and v,
; a0 = table. Its entries have 12 bytes, so bit 2 of the address after an entry alternates from
; line to line.
dither_open macro
        movea.l span_plan_row(a0),a6
        movea.l span_plan_lines(a0),a5
        move.l  span_plan_count(a0),d0
        lsl.l   #2,d0
        lea     (a5,d0.l),a1
        pea     (a1,d0.l*2)
        move.l  span_plan_pitch(a0),-(sp)
        pea     1.w
        move.l  a5,d2
        lsr.l   #2,d2
        move.l  span_plan_odd(a0),d3
        eor.l   d3,d2
        move.l  #$40000000,d0           ; (2, 0)
        move.l  #$00000080,d1           ; (0, 4)
        move.l  #$c0000040,d3           ; (6, 2)
        move.l  #$800000c0,d4           ; (4, 6)
        lsr.l   #1,d2
        bcs.s   .even
        exg     d0,d1
        exg     d3,d4
.even   movem.l d0-d1/d3-d4,-(sp)
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d5
        movea.l a5,a0
        endm

; Opens a span with the chain of two registers: steps of even x in d2 and d3, of odd x in d5 and
; d6, a4 as after chain_open. a5 replaces DITHER_LAST.
dither_chain_open macro
        dither_open
        movea.l d2,a1
        movea.l d5,a2
        sub.l   #$8000,d2
        sub.l   #$4000,d5
        chain_steps
        movea.l d2,a3
        move.l  d3,d6
        move.l  a1,d2
        move.l  a2,d5
        add.l   #$8000,d2
        add.l   #$4000,d5
        chain_steps
        move.l  a3,d5
        movea.w #1,a5
        endm

; Opens a span with S, Q and P in separate registers: steps of even x in d2 (P) and d3 (Q), of odd
; x in d6 and d7. S has one step for both, in a4, as u's two steps differ by a whole texel.
dither_apart_open macro
        dither_open
        exg     d2,d5
        movea.l d2,a1
        movea.l d5,a2
        sub.l   #$4000,d2
        sub.l   #$8000,d5
        apart_steps
        move.l  d2,d6
        move.l  d3,d7
        move.l  a1,d2
        move.l  a2,d5
        add.l   #$4000,d2
        add.l   #$8000,d5
        apart_steps
        endm

; Reads a table entry: d0 = start0:start1, a1 = first pixel, a2 = left, \1's lower word = last.
; \2: *2 or *4 for pixels of 2 or 4 bytes.
dither_entry macro
        move.l  (a0)+,d0                ; start0:left
        movea.w d0,a2
        lea     (a6,d0.w\2),a1
        move.l  (a0)+,\1                ; last:start1
        move.w  \1,d0
        swap    \1
        endm

; d4 = the index of the line's offset: 2 x + y of the first pixel, both modulo 2.
dither_place macro
        move.w  a0,d4
        lsr.w   #3,d4
        move.w  a2,d4
        addx.w  d4,d4
        and.w   #3,d4
        endm

; Draws lines with the chain, 16 pixels a round; \1 \2 draws a pixel. Steps are exchanged so that
; position n of a round uses the step of its pixel's x. \3: *2 or *4; \4: the base of .pixels'
; address, a3 or pc. The code for lines is last: if it does not fit the cache with the pixels, it
; evicts only the first pixels of a round, which only long lines run.
dither_chain_lines macro
        bra     .line
        cnop    0,4
.pixels rept    8
        texel_next d2,d3
        \1     \2
        texel_next d5,d6
        \1     \2
        endr
        dbra    d7,.pixels
.line_next
        adda.l  DITHER_PITCH(sp),a6
        cmpa.l  DITHER_END(sp),a0
        beq.s   .done
.line   dither_entry d7,\3
        move.w  a5,d4
        movea.w d7,a5
        add.w   d7,d4
        lsr.w   #1,d4
        bcc.s   .order
        exg     d2,d5
        exg     d3,d6
.order  sub.w   a2,d7
        bmi.s   .empty
        move.l  (a0)+,d1
        dither_place
        add.l   (sp,d4.w*4),d0
        bcc.s   .moved
        addq.b  #1,d1
.moved  move.w  d7,d4
        not.w   d4
        and.w   #15,d4
        lsr.w   #4,d7
        ifc     '\4','pc'
        lea     .pixels(pc,d4.w*4),a2
        else
        lea     (\4,d4.w*4),a2
        endc
        add.l   a4,d1
        jmp     (a2,d4.w*8)
.empty  addq.l  #4,a0
        bra.s   .line_next
.done   lea     DITHER_BYTES(sp),sp
        rts
        endm

; Draws lines with S, Q and P, 8 pixels a round. \1: bytes a pixel, \2: log2 of that, \3 \4: draws
; a pixel, \5: *2 or *4.
dither_apart_lines macro
        bra     .line
        cnop    0,4
.pixels rept    4
        texel_next_apart d2,d3
        \3     \4
        texel_next_apart d6,d7
        \3     \4
        endr
        cmpa.l  a5,a1
        bne.s   .pixels
.line_next
        adda.l  DITHER_PITCH(sp),a6
        cmpa.l  DITHER_END(sp),a0
        beq     .done
.line   dither_entry d5,\5
        move.w  DITHER_LAST(sp),d4
        move.w  d5,DITHER_LAST(sp)
        add.w   d5,d4
        lsr.w   #1,d4
        bcc.s   .order
        exg     d2,d6
        exg     d3,d7
.order  sub.w   a2,d5
        bmi.s   .empty
        move.l  (a0)+,d1
        lea     \1(a1,d5.w\5),a5
        dither_place
        move.l  d0,d5
        clr.w   d5
        add.w   2(sp,d4.w*4),d0
        add.l   (sp,d4.w*4),d5          ; (Vv below it is never carried)
        bcc.s   .moved
        addq.b  #1,d1
.moved  move.w  a1,d4
        sub.w   a5,d4
        ifne    \2
        asr.w   #\2,d4
        endc
        and.w   #7,d4
        lea     .pixels(pc,d4.w*2),a2
        lea     (a2,d4.w*4),a2
        jmp     (a2,d4.w*8)
.empty  addq.l  #4,a0
        bra     .line_next
.done   lea     DITHER_BYTES(sp),sp
        rts
        endm
