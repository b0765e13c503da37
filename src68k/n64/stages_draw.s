        include "passes.i"

; n64_stages_draw - a polygon's lines, each by a list of passes
;
; in:      a0  n64_stages*  the passes, and where lines begin
;          a1  const scanline*  left and last of each line
;          d0  int32  lines, 1 at least
; reads:   the planes; what the passes read
; writes:  the stages' starts, at and pixels; what the passes write
; formats: planes modulo 2^32
; cost:    about 250 cycles a line and 60 a pass beside the passes; 60 a further plane

; What the passes write between them has room for N64_LINE_PIXELS; longer lines are drawn in parts. Passes keep
; d2-d7/a3-a6.

; d7 = pixels of the line a6, d2 = its first pixel. Goes to \1 if it has none.
line    macro
        moveq   #0,d2
        move.w  scanline_left(a6),d2
        move.w  scanline_last(a6),d7
        ext.l   d7
        sub.l   d2,d7
        addq.l  #1,d7
        ble     \1
        sub.l   #EDGE_BIAS,d2
        endm

; The stages' at = their starts at pixel d2. Uses d0-d1/d4/a0-a2.
values  macro
        movea.l n64_stages_planes(a5),a0
        lea     n64_stages_starts(a5),a1
        lea     n64_stages_at(a5),a2
        move.l  d2,d1
        sub.l   n64_stages_column(a5),d1
        move.w  n64_stages_last_interpolant(a5),d4
.value\@
        move.l  plane_dx(a0),d0
        muls.l  d1,d0
        add.l   (a1)+,d0
        move.l  d0,(a2)+
        lea     plane_sizeof(a0),a0
        dbra    d4,.value\@
        endm

; Goes on to the next line. Uses d0/d4/a0-a1.
down    macro
        movea.l n64_stages_planes(a5),a0
        lea     n64_stages_starts(a5),a1
        move.w  n64_stages_last_interpolant(a5),d4
.start\@
        move.l  plane_dy(a0),d0
        add.l   d0,(a1)+
        lea     plane_sizeof(a0),a0
        dbra    d4,.start\@
        lea     scanline_sizeof(a6),a6
        endm

        routine n64_stages_draw,a0,a1,d0
        save_all
        movea.l a0,a5
        movea.l a1,a6
        move.l  d0,-(sp)
        moveq   #PIXEL_PLACES,d3
.line   line    .down
.part   move.l  #N64_LINE_PIXELS,d6
        cmp.l   d6,d7
        bge.s   .long
        move.l  d7,d6
.long   values
        move.l  n64_stages_pixel_bits(a5),d0
        move.l  d2,d5
        lsl.l   d0,d5
        add.l   n64_stages_pixels(a5),d5
        lea     n64_stages_of(a5),a4
        move.w  n64_stages_last_stage(a5),d4
        call_passes
        add.l   d6,d2
        sub.l   d6,d7
        bne     .part
.down   down
        move.l  n64_stages_pitch(a5),d0
        add.l   d0,n64_stages_pixels(a5)
        subq.l  #1,(sp)
        bne     .line
        addq.l  #4,sp
        return_all

; n64_stages_together - a small polygon's lines: the passes that read iterators line by line, the others once
;
; in:      a0  n64_stages*  as n64_stages_draw; `by_line` passes read iterators
;          a1  const scanline*  left and last of each line
;          d0  int32  lines, 1 at least, of N64_LINE_PIXELS pixels together at most
;          a2  uint32*  room for all pixels
; reads:   the planes; what the passes read
; writes:  the stages' starts and at; what the passes write; pixels, the room
; formats: as n64_stages_draw
; cost:    about 300 cycles a line, 60 a pass that reads iterators, 20 a pixel, beside the passes
        routine n64_stages_together,a0,a1,d0,a2
        save_all
        movem.l d0/a1-a2,-(sp)
        movea.l a0,a5
        movea.l a1,a6
        move.l  d0,-(sp)
        moveq   #0,d5                   ; bytes of the pixels so far
.line   line    .down
        values
        lea     n64_stages_of(a5),a4
        move.w  n64_stages_by_line(a5),d4
        bra.s   .first
.pass   movem.l (a4)+,a0-a3
        adda.l  d5,a1
        move.l  d7,d0
        jsr     PASS_SAVED(a3)
.first  dbra    d4,.pass
        lsl.l   #2,d7
        add.l   d7,d5
.down   down
        subq.l  #1,(sp)
        bne     .line
        addq.l  #4,sp

        move.l  d5,d6
        beq     .done
        lsr.l   #2,d6
        move.l  8(sp),d5
        moveq   #PIXEL_PLACES,d3
        move.w  n64_stages_last_stage(a5),d4
        sub.w   n64_stages_by_line(a5),d4
        call_passes

        movem.l (sp),d3/a6              ; lines
        movea.l d5,a0
        movea.l n64_stages_pixels(a5),a2
        movea.l n64_stages_pitch(a5),a3
        moveq   #2,d1
        cmp.l   n64_stages_pixel_bits(a5),d1
        bne.s   .words
.longs  line    .longs_next
        lea     (a2,d2.l*4),a1
        subq.w  #1,d7
.long   move.l  (a0)+,(a1)+
        dbra    d7,.long
.longs_next
        adda.l  a3,a2
        lea     scanline_sizeof(a6),a6
        subq.l  #1,d3
        bne     .longs
        bra.s   .done
.words  line    .words_next
        lea     (a2,d2.l*2),a1
        subq.w  #1,d7
.word   move.w  (a0)+,(a1)+
        dbra    d7,.word
.words_next
        adda.l  a3,a2
        lea     scanline_sizeof(a6),a6
        subq.l  #1,d3
        bne     .words
.done   lea     12(sp),sp
        return_all
