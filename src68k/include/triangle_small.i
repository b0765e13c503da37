; Small triangles: SMALL_HEIGHT sixteenths of a line high and as wide as the mapper's code has pixels.
;
; An edge is one register, ff:offset: 16 bits of fraction and the distance from the frame's row where
; the triangle begins. Adding its step, ff:whole + pitch, moves it down a line; a carry moves it one
; pixel to the right. The offset belongs to the first pixel at or right of the edge: the register
; starts 2/65536 pixel below x + 1.
;
; Its pixels are exact: x is a multiple of 1/dy, of which the largest is 1/SMALL_HEIGHT pixel, 18.2
; units of 1/65536. It is never too large: products by the table may be, by |dx| / 65536 units a
; line, 1.2 units in 14.94 lines for |dx| up to SNAPPED_WIDTH; 2 were taken off. It is too small by
; less than 2 + 1 (the start's shift) + 14.94 (slopes rounded down) = 17.94 units.

        include "triangle.i"

; The stack while lines are drawn, longwords.
                rsreset
small_count     rs.l    1               ; lines of this part that are left
small_step      rs.l    1               ; of the short edge
small_step_2    rs.l    1               ; of the second short edge
small_start_2   rs.l    1               ; where that begins
small_count_1   rs.l    1
small_count_2   rs.l    1               ; its lines, until it is taken
small_list      rs.l    1
small_sizeof    rs.l    0

; An edge from the vertex with x:y \2 over dx:dy \1: d4 = its step, d3 = its start. a4 the
; reciprocals, d5 = 15. Uses d6.
edge_small macro
        move.l  \1,d4
        clr.w   d4
        add.l   d4,d4                   ; 2^17 dx
        muls.l  (a4,\1.w*4),d6:d4       ; 16.48
        move.l  d6,d4
        swap    d4                      ; ff:whole
        add.w   batch_pitch+2(a5),d4
        move.w  \2,d3
        not.w   d3
        and.l   d5,d3                   ; prestep
        muls.l  d3,d6
        move.l  \2,d3
        clr.w   d3
        add.l   d6,d3
        asr.l   #4,d3
        subq.l  #2,d3
        swap    d3                      ; ff:x
        endm

; The long edge, whose dx:dy is d2: pushes its start; a2 = its step, d1 = its reciprocal, d3 = the
; prestep in 1/16 line, d5 = the slope's fraction, 0.31, d6 = the distance from the edge to the
; first pixel, 0.16, both away from the edge. d5 is 15 before. \1: left or right. Uses d0/d2/d7.
long_small macro
        movea.l batch_reciprocals(a5),a2
        move.l  (a2,d2.w*4),d1
        asr.l   d5,d2
        muls.l  d1,d7:d2
        move.l  d2,d6
        move.w  d7,d2
        move.l  d2,d7
        swap    d7
        add.w   batch_pitch+2(a5),d2
        movea.l d2,a2
        move.l  (a1),d0
        move.w  d0,d3
        not.w   d3
        and.l   d5,d3
        muls.l  d3,d7
        clr.w   d0
        add.l   d7,d0
        asr.l   #4,d0
        subq.l  #2,d0
        move.l  d6,d5
        lsr.l   #1,d5
        moveq   #0,d6
        move.w  d0,d6
        ifc     '\1','left'
        not.w   d6
        else
        neg.l   d5
        addq.l  #1,d6
        endc
        swap    d0
        move.l  d0,-(sp)
        endm

; The same for the value at \1 in a vertex, whose difference along the edge is \2 and whose step a
; pixel is \3: \4 (an address register) = the value at the first pixel, d7 = its step a line. Takes
; d1, d3, d5 and d6 from long_small. Uses d0/d2.
value_start macro
        move.l  \2,d2
        add.l   d2,d2
        muls.l  d1,d7:d2
        value_first \1,\3,\4
        endm

; Sets up a small triangle whose long edge is on the side \1, left or right, with the values of the
; mapper \2: its macro \2_small finds them and goes to its lines, with d6 = the short edge's start.
small_set_up macro
        triangle_lines triangle_next
        move.l  a0,-(sp)
        movea.l d6,a6                   ; the area
        movea.l batch_reciprocals(a5),a4
        move.w  batch_pitch+2(a5),d6
        mulu.w  d3,d6
        movea.l batch_row(a5),a0
        adda.l  d6,a0                   ; the first line's row
        sub.w   d7,d4
        beq     .one\@
        sub.w   d3,d7
        beq     .two\@
        move.w  batch_pitch+2(a5),d6
        mulu.w  d7,d6
        move.l  d4,-(sp)
        move.l  d7,-(sp)
        move.l  d6,-(sp)
        move.l  d2,d7
        sub.l   d1,d7
        add.l   d0,d1
        edge_small d7,d1
        sub.l   d0,d1
        add.w   2(sp),d3
        move.l  d3,(sp)
        move.l  d4,-(sp)
        edge_small d1,d0
.edges\@
        move.l  d4,-(sp)
        move.l  small_count_1-small_step(sp),-(sp)
        move.l  d3,-(sp)
        \2_small \1
.one\@
        sub.w   d3,d7
        clr.l   -(sp)
        move.l  d7,-(sp)
        subq.l  #8,sp
        edge_small d1,d0
        bra     .edges\@
.two\@
        clr.l   -(sp)
        move.l  d4,-(sp)
        subq.l  #8,sp
        move.l  d2,d7
        sub.l   d1,d7
        add.l   d0,d1
        edge_small d7,d1
        sub.l   d0,d1
        bra     .edges\@
        endm

; \2 = the negative number of a line's pixels, from the long edge \1, left or right, at \3,
; to the short one, at \4: pointers or offsets. None is negative: edges are exact.
line_pixels macro
        ifc     '\1','left'
        move.w  \3,\2
        sub.w   \4,\2
        else
        move.w  \4,\2
        sub.w   \3,\2
        endc
        endm

; The lines of small triangles with values of the mapper \2, long edge on the side \1. a0 the row,
; a6 the long edge's step, d5 the long edge, d6 the short one. \3: a register whose lower word
; becomes the negative number of pixels. \4: the lines left, \5: the short edge's step: registers, or
; their places on the stack. The macro \2_zero clears d4's lower word if it needs to, \2_line steps
; the values a line, \2_more_\1 a pixel, \2_keep keeps them; \2_enter goes to the pixels before the
; label \2_end_\1; \2_pixel_\1 is one, at a1.
small_lines macro
        cnop    0,4
        rept    \2_unrolled
        \2_pixel_\1
        endr
\2_end_\1
        subq.l  #1,\4
        beq.s   small_part_\1
        \2_zero
        add.l   \5,d6
        addx.w  d4,d6
small_stepped_\1
        \2_line d4,small
        add.l   a6,d5
        bcs.s   small_more_\1
small_first_\1
        \2_keep
        line_pixels \1,\3,d5,d6
        lea     (a0,d5.w),a1
        \2_enter \2_end_\1,\3
small_more_\1
        addq.w  #1,d5
        \2_more_\1 d4
        \2_keep
        line_pixels \1,\3,d5,d6
        lea     (a0,d5.w),a1
        \2_enter \2_end_\1,\3
small_part_\1
        move.l  small_count_2(sp),\4
        beq     small_end
        clr.l   small_count_2(sp)
        move.l  small_step_2(sp),\5
        move.l  small_start_2(sp),d6
        \2_zero
        bra     small_stepped_\1
        endm

; Ends a small triangle.
small_close macro
small_end
        lea     small_list(sp),sp
        movea.l (sp)+,a0
        movea.l sp,a5
        bra     triangle_next
        endm
