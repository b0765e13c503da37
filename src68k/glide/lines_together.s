        include "passes.i"

        xref    _glide_walk,_glide_divide

; glide_lines_together - a small polygon's lines: its first pass line by line, the others once
;
; in:      a0  struct glide_lines*  as glide_lines; passes behind the first read no iterators
;          a1  uint32*  room for all pixels
; reads:   the lines, the passes' input and data
; writes:  pixels, the passes' output, the room; the points
; formats: as glide_lines. glide_walk is done here, pixel by pixel, and so is glide_divide of fewer than
;          MANY pixels, where it clamps neither quotients nor coordinates: without their set-up
; cost:    about 150 cycles a line and 45 a pixel to coordinates, 250 if they are divided; 40 a line and 20
;          a pixel to the frame; the passes' own

; A pass changes d0-d1/a0-a1 alone.

MANY    equ     20                      ; pixels: glide_divide takes less time on longer lines

start   equ     glide_points_start
across  equ     glide_points_across
down    equ     glide_points_down
at      equ     glide_points_at
s       equ     glide_iterators_s
t       equ     glide_iterators_t
w       equ     glide_iterators_w
stages  equ     glide_lines_stages

; d0 = x of the line a6, d6 = its pixels less 1. Goes to \1 if it has none.
line    macro
        moveq   #0,d0
        move.w  scanline_left(a6),d0
        move.w  scanline_last(a6),d6
        ext.l   d6
        sub.l   d0,d6
        bmi     \1
        endm

; Goes on with the next line, if there is one, at \1; (sp): the end of the lines.
next_line macro
        lea     scanline_sizeof(a6),a6
        cmpa.l  (sp),a6
        bne     \1
        endm

; \1, \2, d0 = the iterators s, t and w of the points a3 at the line's first pixel, d0 from the bias.
iterators macro
        move.l  across+s(a3),\1
        move.l  across+t(a3),\2
        muls.l  d0,\1
        muls.l  d0,\2
        muls.l  across+w(a3),d0
        add.l   start+s(a3),\1
        add.l   start+t(a3),\2
        add.l   start+w(a3),d0
        endm

; The line's start of the points a3 becomes that of the next line. Uses d0-d2.
down_line macro
        movem.l down(a3),d0-d2
        add.l   d0,start+s(a3)
        add.l   d1,start+t(a3)
        add.l   d2,start+w(a3)
        endm

; Coordinates of the line's d6 + 1 pixels from the iterators d5, d7 and d0 by the pass a5, to a4. Uses d6.
by_pass macro
        lea     at+glide_iterators_sizeof(a3),a0
        move.l  d0,-(a0)
        move.l  d7,-(a0)
        move.l  d5,-(a0)
        addq.l  #1,d6
        move.l  d6,d0
        movea.l a4,a1
        lea     (a4,d6.l*4),a4
        jsr     PASS_SAVED(a5)
        endm

; Writes \1 * 2^d3 / d0, rounded down, less a0 to a4; d4 = 32 - d3. Goes to .odd where glide_divide clamps
; quotients. Uses d1-d2.
divide  macro
        move.l  \1,d1
        tst.l   d1
        minus   <neg.l d1>
        lsr.l   #1,d1
        cmp.l   d0,d1
        bhs     .odd
        move.l  \1,d2
        move.l  \1,d1
        asr.l   d4,d2
        lsl.l   d3,d1
        divs.l  d0,d2:d1
        add.l   d2,d2                   ; the remainder's sign
        moveq   #0,d2
        subx.l  d2,d1
        sub.w   a0,d1
        move.w  d1,(a4)+
        endm

; On the stack:
end     equ     0
lines   equ     4
room    equ     8

        routine glide_lines_together,a0,a1
        save_all
        movem.l a0-a1,-(sp)
        movea.l a0,a5
        movea.l glide_lines_lines(a5),a6
        move.l  glide_lines_count(a5),d0
        mulu.w  #scanline_sizeof,d0
        add.l   a6,d0
        move.l  d0,-(sp)
        movea.l stages+glide_stage_in(a5),a0
        movea.l stages+glide_stage_out(a5),a4
        lea     -at(a0),a0              ; the points
        lea     _glide_walk,a1
        cmpa.l  stages+glide_stage_pass(a5),a1
        bne     .any

        movea.l stages+glide_stage_constants(a5),a1
        move.w  glide_steps_shift(a1),d7
        movea.w glide_steps_half(a1),a1
        movem.l start(a0),d1-d2
        movem.l across(a0),a2-a3
.line   line    .next
        move.l  a2,d3
        move.l  a3,d4
        muls.l  d0,d3
        muls.l  d0,d4
        add.l   d1,d3
        add.l   d2,d4
.pixel  move.l  d3,d5
        move.l  d4,d0
        asr.l   d7,d5
        asr.l   d7,d0
        sub.w   a1,d5
        sub.w   a1,d0
        swap    d5
        move.w  d0,d5
        add.l   a2,d3
        add.l   a3,d4
        move.l  d5,(a4)+
        dbra    d6,.pixel
.next   add.l   down+s(a0),d1
        add.l   down+t(a0),d2
        next_line .line
        bra     .coordinates

.any    movea.l a0,a3
        movea.l stages+glide_stage_constants(a5),a2
        movea.l stages+glide_stage_pass(a5),a5
        lea     _glide_divide,a0
        cmpa.l  a0,a5
        bne.s   .any_line
        moveq   #-1,d0
        cmp.l   glide_steps_last_s(a2),d0       ; and last_t
        beq     .divide

.any_line
        line    .any_next
        iterators d5,d7
        by_pass
.any_next
        down_line
        next_line .any_line
        bra     .reload

.divide moveq   #30,d3
        sub.w   glide_steps_shift(a2),d3
        moveq   #32,d4
        sub.w   d3,d4
.divide_line
        line    .divide_next
        cmpi.w  #MANY-1,d6
        bge     .many
        iterators d5,d7
        movea.l a4,a1
        movea.w glide_steps_half(a2),a0
.divide_pixel
        tst.l   d0
        ble     .odd
        divide  d5
        divide  d7
        add.l   across+s(a3),d5
        add.l   across+t(a3),d7
        add.l   across+w(a3),d0
        dbra    d6,.divide_pixel
.divide_next
        down_line
        next_line .divide_line
        bra     .reload
.odd    movea.l a1,a4                   ; the whole line again
        line    .divide_next
.many   iterators d5,d7
        by_pass
        bra     .divide_next
.reload movea.l lines(sp),a5

.coordinates
        move.l  a4,d6
        sub.l   stages+glide_stage_out(a5),d6
        beq     .done
        lsr.l   #2,d6                   ; pixels
        move.l  room(sp),d5
        moveq   #PIXEL_PLACES,d3
        lea     stages+glide_stage_sizeof(a5),a4
        move.w  glide_lines_last_stage(a5),d4
        subq.w  #1,d4
        call_passes

        movea.l d5,a0
        movea.l glide_lines_lines(a5),a6
        movea.l glide_lines_pixels(a5),a2
        movea.l glide_lines_pitch(a5),a3
        moveq   #2,d1
        cmp.l   glide_lines_bits(a5),d1
        bne.s   .words
.longs  line    .longs_next
        lea     (a2,d0.l*4),a1
.long   move.l  (a0)+,(a1)+
        dbra    d6,.long
.longs_next
        adda.l  a3,a2
        next_line .longs
        bra.s   .done
.words  line    .words_next
        lea     (a2,d0.l*2),a1
.word   move.w  (a0)+,(a1)+
        dbra    d6,.word
.words_next
        adda.l  a3,a2
        next_line .words
.done   lea     12(sp),sp
        return_all
