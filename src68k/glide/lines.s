        include "passes.i"

; glide_lines - a polygon's lines, each by the same passes
;
; in:      a0  struct glide_lines*  the lines, what units iterate, the passes
; reads:   the lines, the passes' input and data
; writes:  pixels, the passes' output; the points, the place of the next line
; formats: iterators modulo 2^32
; cost:    about 100 cycles a line, 130 for each unit's points, 200 if w changes, 40 a pass

; A pass changes d0-d1/a0-a1 alone.

start   equ     glide_points_start
across  equ     glide_points_across
down    equ     glide_points_down
at      equ     glide_points_at

; The first pixel's iterator \1 = \2, the line's, + d0 steps. Uses d5.
first   macro
        move.l  across+\1(a0),d5
        muls.l  d0,d5
        add.l   \2,d5
        move.l  d5,at+\1(a0)
        endm

        routine glide_lines,a0
        save_all
        movea.l a0,a5
        movea.l glide_lines_lines(a5),a6
        move.l  glide_lines_count(a5),d7
        subq.l  #1,d7
.line   moveq   #0,d0
        move.w  scanline_left(a6),d0
        lea     glide_lines_points(a5),a0
        move.w  glide_lines_last_points(a5),d4
.points movem.l start(a0),d1-d2
        first   glide_iterators_s,d1
        first   glide_iterators_t,d2
        add.l   down+glide_iterators_s(a0),d1
        add.l   down+glide_iterators_t(a0),d2
        movem.l d1-d2,start(a0)
        tst.l   glide_points_deep(a0)
        beq.s   .constant
        move.l  start+glide_iterators_w(a0),d3
        first   glide_iterators_w,d3
        add.l   down+glide_iterators_w(a0),d3
        move.l  d3,start+glide_iterators_w(a0)
.constant
        lea     glide_points_sizeof(a0),a0
        dbra    d4,.points
        move.l  glide_lines_pixels(a5),d5
        move.l  d5,d1
        add.l   glide_lines_pitch(a5),d1
        move.l  d1,glide_lines_pixels(a5)
        move.w  scanline_last(a6),d6
        ext.l   d6
        sub.l   d0,d6
        bmi.s   .next
        addq.l  #1,d6                   ; pixels
        move.l  glide_lines_bits(a5),d1
        lsl.l   d1,d0
        add.l   d0,d5                   ; the first one
        moveq   #PIXEL_PLACES,d3
        lea     glide_lines_stages(a5),a4
        move.w  glide_lines_last_stage(a5),d4
        call_passes
.next   lea     scanline_sizeof(a6),a6
        dbra    d7,.line
        return_all
