; Triangles that are not small. An edge is a pointer to its first pixel and an error of 32 bits: a
; carry moves the pointer one pixel to the right.
;
; Its pixels are exact: x is a multiple of 1/dy. In units of 2^-32 pixel: the error begins BELOW under
; x + 1. Products by the table are off by |dx| a line where dy is below FINER_HEIGHT, 86,733 in 16.94
; lines for |dx| up to SNAPPED_WIDTH, so x is never too large. It is too small by less than 189,140,
; of 2^32 / 4,080 = 1,052,688. From FINER_HEIGHT on they are off by |dx| / 256, 2,560 in 128 lines, and
; fractions, rounded down, by 130: x is too small by less than 105,100, of 2^32 / 32,752 = 131,136.

        include "triangle_small.i"

; The stack while lines are drawn, longwords.
                rsreset
wide_count      rs.l    1               ; lines of this part that are left
wide_l_part     rs.l    1
wide_l_step     rs.l    1
wide_r_error    rs.l    1
wide_r          rs.l    1
wide_r_part     rs.l    1
wide_r_step     rs.l    1
wide_r_error_2  rs.l    1
wide_r_part_2   rs.l    1
wide_r_step_2   rs.l    1
wide_count_1    rs.l    1
wide_r_2        rs.l    1
wide_count_2    rs.l    1               ; of the second part, until it is taken
wide_list       rs.l    1
wide_sizeof     rs.l    0

BELOW           equ     64              ; 2^-21 pixel
BELOW_FINER     equ     8               ; from FINER_HEIGHT on

; \1:\2 = the slope dx:dy of \3, whole pixels and a fraction, 0.32. d3 = the slope as 15.17, d7 = how
; far below x + 1 the edge begins. \4: dy's reciprocal. d5 = 15.
slope_wide macro
        move.l  \3,\2
        clr.w   \2
        cmp.w   #FINER_HEIGHT,\3
        bcs.s   .coarse\@
        asr.l   #7,\2                   ; 2^9 dx
        moveq   #BELOW_FINER,d7
        bra.s   .scaled\@
.coarse\@
        add.l   \2,\2                   ; 2^17 dx
        moveq   #BELOW,d7
.scaled\@
        muls.l  \4,\1:\2                ; 16.48
        move.l  \2,d3
        add.l   d3,d3
        move.l  \1,d3
        addx.l  d3,d3
        move.w  \1,\2
        swap    \2
        swap    \1
        ext.l   \1
        endm

; From the vertex x:y \1, d3 and d7: d6 = x of the first line's first pixel, d4 its error. d5 = 15.
place_wide macro
        move.l  \1,d6
        move.l  d6,d4
        not.w   d4
        and.l   d5,d4                   ; prestep
        muls.l  d4,d3
        clr.w   d6
        add.l   d6,d6
        add.l   d3,d6                   ; 11.21
        sub.l   d7,d6
        move.l  d6,d4
        lsl.l   #8,d4
        lsl.l   #3,d4
        bfextu  d6{0:11},d6
        endm

; An edge from the vertex x:y \2 over dx:dy \1: pushes step and part; d6 x, d4 its error. Uses
; d3/d7.
edge_wide macro
        slope_wide d6,d4,\1,(a4,\1.w*4)
        add.l   batch_pitch(a5),d6
        move.l  d6,-(sp)
        move.l  d4,-(sp)
        place_wide \2
        endm

; The long edge, whose dx:dy is d2: a0 = its first pixel, pushes step, part and error; d1 = its
; reciprocal, d3 = the prestep in 1/16 line, d4 = what value_start_wide shifts by and adds, d5 = the slope's
; fraction, 0.31, d6 = the distance from the edge to the first pixel, 0.16, both away from the edge.
; d5 is 15 before. \1: left or right. Uses d0/d7.
long_wide macro
        movea.l batch_reciprocals(a5),a5
        move.l  (a5,d2.w*4),d1
        lea     wide_sizeof-wide_r_error(sp),a5
        slope_wide d6,d4,d2,d1
        add.l   batch_pitch(a5),d6
        move.l  d6,-(sp)
        move.l  d4,-(sp)
        move.l  d4,d0
        place_wide (a1)
        adda.l  d6,a0
        move.l  d4,-(sp)
        moveq   #0,d6
        swap    d4
        move.w  d4,d6
        move.w  2(a1),d3
        not.w   d3
        and.l   d5,d3
        move.l  d0,d5
        lsr.l   #1,d5
        ifc     '\1','left'
        not.w   d6
        else
        neg.l   d5
        addq.l  #1,d6
        endc
        move.l  d7,d4
        cmp.w   #SNAPPED_TALL*16,d2
        blt.s   .low\@
        add.w   #TALL_RAISED*16,d4
.low\@
        endm

; The same for the value at \1 in a vertex, whose difference along the edge is \2 and whose step a
; pixel is \3: \4 (an address register) = the value at the first pixel, d7 = its step a line. Takes
; d1 and d3 to d6 from long_wide. Uses d0/d2.
value_start_wide macro
        move.l  \2,d2
        muls.l  d1,d7:d2
        add.l   d2,d2
        addx.l  d7,d7
        asr.l   d4,d7
        value_first \1,\3,\4,d4
        endm

; Sets up a triangle that is not small: long edge on the side \1, left or right, values of the
; mapper \2, whose macro \2_wide finds them and goes to its lines.
wide_set_up macro
        cmp.w   #SNAPPED_TALL*16,d2
        bge     .tall\@
.low\@  triangle_lines triangle_next
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
        add.l   a0,d6
        move.l  d4,-(sp)
        move.l  d6,-(sp)
        move.l  d7,-(sp)
        move.l  d2,d3
        sub.l   d1,d3
        add.l   d0,d1
        edge_wide d3,d1
        sub.l   d0,d1
        add.l   d6,wide_r_2-wide_r_part_2(sp)
        move.l  d4,-(sp)
        edge_wide d1,d0
.edges\@
        add.l   a0,d6
        move.l  d6,-(sp)
        move.l  d4,-(sp)
        \2_wide \1
.one\@
        sub.w   d3,d7
        clr.l   -(sp)
        subq.l  #4,sp
        move.l  d7,-(sp)
        lea     -12(sp),sp
        edge_wide d1,d0
        bra     .edges\@
.two\@
        clr.l   -(sp)
        subq.l  #4,sp
        move.l  d4,-(sp)
        lea     -12(sp),sp
        move.l  d2,d3
        sub.l   d1,d3
        add.l   d0,d1
        edge_wide d3,d1
        sub.l   d0,d1
        bra     .edges\@
.tall\@ cmp.w   #SNAPPED_LINES*16,d2
        bge     triangle_handed
        st      batch_room(a5)
        bra     .low\@
        endm

; batch_room = below 0 if a line of the triangle may have more than \1 * 16 pixels: 1 or 4. Uses d7.
triangle_room macro
        moveq   #0,d7
        move.w  d2,d7
        lsl.l   #8,d7
        ifeq    \1-4
        lsl.l   #2,d7
        endc
        sub.l   d6,d7
        move.l  d7,batch_room(a5)
        endm

; Sets up the triangles of a batch with values of the mapper \1; small ones are up to \2 * 16 pixels
; wide, narrow ones up to \3 * 16, if the mapper makes that difference.
triangles_set_up macro
        triangle_fetch
        triangle_order .right
        triangle_small .left_wide,\2
        small_set_up left,\1
.left_wide
        ifnb    \3
        triangle_room \3
        endc
        wide_set_up left,\1
.right  exg     d1,d2
        exg     a2,a3
        triangle_small .right_wide,\2
        small_set_up right,\1
.right_wide
        ifnb    \3
        triangle_room \3
        endc
        wide_set_up right,\1
        endm

; Begins the lines, long edge on the side \1.
wide_begin macro
        tst.l   wide_sizeof+batch_room(sp)
        bpl     narrow_begin_\1
        movea.l wide_count_1(sp),a1
        adda.l  wide_count_2(sp),a1
        cmpa.w  #SNAPPED_TALL,a1
        blt     wide_begin_\1
        bra     tall_first_\1
        endm

; The lines of triangles that are not small with values of the mapper \2, long edge on the side \1; \3: narrow,
; wide or tall. a0 the long edge's pixel, \6 the short one's, d5 and d6 their errors, \4 and \5 part
; and step of the long edge, \7 as \3 of small_lines. Macros as there; \2_short steps the short
; edge, \2_second makes it the second one, \2_counted makes the part's lowest byte 1. \2_block is a
; line's pixels, with a test for more of them unless the triangle is narrow, \2_go goes there.
;
; But for tall triangles d5's lowest byte counts the lines up to 0: the edge's fractions have 24 bits.
wide_lines macro
        cnop    0,4
        \2_block \1,\3
\3_next_\1
        ifc     '\3','tall'
        subq.l  #1,(sp)
        else
        tst.b   d5
        endc
        beq.s   \3_part_\1
        \2_short
\3_stepped_\1
        \2_zero
        \2_line wide
        adda.l  \5,a0
        add.l   \4,d5
        bcs.s   \3_more_\1
\3_first_\1
        \2_keep
        line_pixels \1,\7,a0,\6
        movea.l a0,a1
        \2_go \1,\3
\3_more_\1
        addq.l  #1,a0
        \2_more_\1
        ifnc    '\3','narrow'
        bra.s   \3_first_\1            ; the cache has no room for it twice
        else
        \2_keep
        line_pixels \1,\7,a0,\6
        movea.l a0,a1
        \2_go \1,\3
        endc
\3_part_\1
        ifc     '\3','tall'
        move.l  wide_count_2(sp),(sp)
        beq     wide_end
        else
        move.b  wide_count_2+3(sp),d5
        beq     wide_end
        neg.b   d5
        endc
        clr.l   wide_count_2(sp)
        \2_second
        bra     \3_stepped_\1
        ifnc    '\3','tall'
\3_begin_\1
        move.b  wide_count_1+3(sp),d5
        neg.b   d5
        addq.b  #1,d5
        \2_counted
        bra     \3_first_\1
        endc
        endm

; Ends a wide triangle.
wide_close macro
wide_end
        lea     wide_list(sp),sp
        movea.l (sp)+,a0
        movea.l sp,a5
        bra     triangle_next
        endm
