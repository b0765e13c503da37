; The lines of triangles that are not small, where a mapper steps values from line to line. They are
; of three classes: narrow ones have no line of more pixels than the code has, wide ones do, tall ones
; have SNAPPED_TALL lines or more. In narrow and wide ones the lowest byte of the long edge's error
; counts lines up to 0: stepping the error steps it too.

        include "triangle_wide.i"

; batch_room = below 0 if a line of the triangle may have more than \1 * 16 pixels: 2 or 4. Uses d7.
triangle_room macro
        moveq   #0,d7
        move.w  d2,d7
        lsl.l   #8,d7
        lsl.l   #\1>>1,d7
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

; Begins the lines, long edge on the side \1, with values of the mapper \2: \2_narrow begins those of
; narrow triangles, \2_begin of all others. The error d5 has no lowest byte yet.
wide_begin macro
        subq.l  #4,sp
        move.b  wide_sizeof+batch_room(sp),d5
        bmi.s   .wide\@
        \2_narrow \1
.wide\@ \2_begin
        add.b   d5,d5
        bvs.s   .tall\@
        lines_counted \2
        bra     wide_first_\1
.tall\@ clr.b   d5
        move.l  wide_count_1(sp),(sp)
        bra     tall_first_\1
        endm

; Makes d5's lowest byte count the first part's lines; \1_counted makes the lowest byte of the long
; edge's part 1.
lines_counted macro
        move.b  wide_count_1+3(sp),d5
        neg.b   d5
        addq.b  #1,d5
        \1_counted
        endm

; The lines of triangles of the class \3 with values of the mapper \2, long edge on the side \1. a0 the
; long edge's pixel, \6 the short one's, d5 and d6 their errors, \4 and \5 part and step of the long
; edge, \7 as \3 of small_lines, \8 a register whose lowest byte, or all of it, is 0. Macros as there;
; \2_short steps the short edge, \2_second makes it the second one. \2_block is a line's pixels, with
; a test for more of them unless the triangle is narrow; \2_go goes there.
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
        ifc     '\3','tall'
        \2_zero
        endc
        \2_line \8,\3
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
        \2_more_\1 \8
        ifc     '\3','tall'
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
        endm

; Ends a wide triangle.
wide_close macro
wide_end
        lea     wide_list(sp),sp
        movea.l (sp)+,a0
        movea.l sp,a5
        bra     triangle_next
        endm
