; Triangles that are not small. An edge is a pointer to its first pixel and an error of 32 bits: a
; carry moves the pointer one pixel to the right.
;
; Its pixels are exact: x is a multiple of 1/dy. In units of 2^-32 pixel: the error begins BELOW or
; BELOW_FINER under x + 1, 131,072 or 16,384, and up to 30,720 more, as there the slope is 15.17.
; Products by the table are off by |dx| a line where dy is below FINER_HEIGHT, 86,733 in 16.94 lines
; for |dx| up to SNAPPED_WIDTH, from there on by |dx| / 256, 5,120 in 256 lines; a count of lines in
; the lowest byte carries 512 at most. So x is never too large. Fractions are rounded down, to 24 bits
; if lines are fewer than SNAPPED_TALL: by 256 a line. So x is too small by less than
;       252,900  of 2^32 / 4,080 = 1,052,688     below FINER_HEIGHT
;        82,500  of 2^32 / 32,752 = 131,136      below SNAPPED_TALL lines
;        52,500  of 2^32 / 65,520 = 65,552       in more

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

TALL            equ     $80             ; batch_room's first byte: it overflows where it is doubled
; Their lowest six bits are also what shifts the values' steps (value_start_wide).
BELOW           equ     64              ; 2^-21 pixel
BELOW_FINER     equ     8               ; from FINER_HEIGHT on

; \1:\2 = the slope dx:dy of \3, whole pixels and a fraction, 0.32. d3 = the slope as 15.17, d7 = how
; far below x + 1 the edge begins, 11.21. \4: dy's reciprocal. d5 = 15.
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

; d6 = x of the edge on its first line, 11.21, from the vertex x:y \1, the prestep \2, the slope d3 and
; d7, which is taken off.
place_wide macro
        muls.l  \2,d3
        move.l  \1,d6
        clr.w   d6
        add.l   d6,d6
        add.l   d3,d6
        sub.l   d7,d6
        endm

; \1 = the prestep of y \2, in 1/16 line. d5 = 15.
prestep_wide macro
        move.w  \2,\1
        not.w   \1
        and.l   d5,\1
        endm

; \2 = the error of x \1, 11.21.
error_wide macro
        move.l  \1,\2
        lsl.l   #8,\2
        lsl.l   #3,\2
        endm

; An edge from the vertex x:y \2 over dx:dy \1: pushes step and part; d6 x, d4 its error. Uses
; d3/d7.
edge_wide macro
        slope_wide d6,d4,\1,(a4,\1.w*4)
        add.l   batch_pitch(a5),d6
        move.l  d6,-(sp)
        move.l  d4,-(sp)
        prestep_wide d4,\2
        place_wide \2,d4
        error_wide d6,d4
        bfextu  d6{0:11},d6
        endm

; The long edge, whose dx:dy is d2: a0 = its first pixel, pushes step, part and error; d1 = its
; reciprocal, d3 = the prestep in 1/16 line, d4 = what value_start_wide shifts by and adds, d5 = the
; slope's fraction, 0.31, d6 = the distance from the edge to the first pixel, 0.16, both away from the
; edge. d5 is 15 before. \1: left or right. Uses d0/d7.
long_wide macro
        movea.l batch_reciprocals(a5),a5
        move.l  (a5,d2.w*4),d1
        lea     wide_sizeof-wide_r_error(sp),a5
        slope_wide d6,d4,d2,d1
        add.l   batch_pitch(a5),d6
        move.l  d6,-(sp)
        move.l  d4,-(sp)
        prestep_wide d0,snapped_vertex_y(a1)
        move.l  d4,d5
        lsr.l   #1,d5
        place_wide (a1),d0
        move.l  d0,d3
        error_wide d6,d4
        move.l  d4,-(sp)
        bfextu  d6{0:11},d4
        adda.l  d4,a0
        bfextu  d6{11:16},d6
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
        move.b  #TALL,batch_room(a5)
        bra     .low\@
        endm
