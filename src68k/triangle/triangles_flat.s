        include "triangle_lines.i"

; triangles_flat - draws a batch of triangles in one colour
;
; in:      a0  triangle_plan*  the list, the frame, the colour, the reciprocals
; out:     d0  triangle*  as triangles_affine
; reads:   the plan, its list, the vertices' x and y, the reciprocals
; writes:  pixels
; formats: vertices in 12.4; 8-bit chunky pixels, four of them in colour
; error:   none for the snapped vertices
; cost:    bench rows polygon_flat

; d0 is the colour, a1 where it goes. Both edges step without a branch, as no value follows them.
;
; Small: d5 and d6 are the left and the right edge, a6 and a2 their steps, d1 the lines left, d2 0.
;
; Wide: d3 and d4 are the left and the right edge's pointers, d1 and d2 their errors, d5 and d6 steps,
; a4 and a5 parts, a0 the lines left, (sp) what takes the second part.

SHORT           equ     10              ; fewer pixels are filled byte by byte

; The lines of small triangles, long edge on the side \1.
small_lines_flat macro
        cnop    0,4
        rept    32
        move.b  d0,(a1)+
        endr
flat_end_\1
        subq.w  #1,d1
        beq.s   flat_second_\1
        add.l   a6,d5
        addx.w  d2,d5
        add.l   a2,d6
        addx.w  d2,d6
flat_line_\1
        move.w  d5,d4
        sub.w   d6,d4
        lea     (a0,d5.w),a1
        jmp     flat_end_\1(pc,d4.w*2)
flat_second_\1
        move.w  small_count_2+2(sp),d1
        beq     small_end
        clr.l   small_count_2(sp)
        ifc     '\1','left'
        add.l   a6,d5
        addx.w  d2,d5
        move.l  small_start_2(sp),d6
        movea.l small_step_2(sp),a2
        else
        add.l   a2,d6
        addx.w  d2,d6
        move.l  small_start_2(sp),d5
        movea.l small_step_2(sp),a6
        endc
        bra.s   flat_line_\1
        endm

flat_small macro
        edge_small d2,d0
        move.l  batch_source(a5),d0
        ifc     '\1','left'
        movea.l d4,a6
        move.l  d3,d5
        move.l  (sp)+,d6
        movea.l small_step(sp),a2
        else
        movea.l d4,a2
        move.l  d3,d6
        move.l  (sp)+,d5
        movea.l small_step(sp),a6
        endc
        move.w  small_count+2(sp),d1
        moveq   #0,d2
        bra     flat_line_\1
        endm

; The lines of wide triangles. A line that is not short is a longword at its first pixel, those at
; boundaries from the next one on, and one that ends at its last pixel: they may overlap.
wide_lines_flat macro
        cnop    0,4
        rept    SNAPPED_WIDTH/4
        move.l  d0,(a1)+
        endr
flat_end
flat_next
        subq.l  #1,a0
        move.l  a0,d7
        beq.s   flat_part
        add.l   a4,d1
        addx.l  d5,d3
flat_right
        add.l   a5,d2
        addx.l  d6,d4
flat_line
        movea.l d3,a1
        move.w  d3,d7
        sub.w   d4,d7
        cmp.w   #-SHORT,d7
        bgt.s   flat_short
        movea.l d4,a2
        move.l  d0,(a1)
        move.l  d0,-(a2)
        move.l  d3,d7
        or.w    #3,d7
        movea.l d7,a1
        addq.l  #1,a1                   ; the next boundary
        sub.w   d4,d7
        asr.w   #2,d7                   ; less one longword
        jmp     flat_end+2(pc,d7.w*2)
flat_part
        movea.l wide_count_2(sp),a0
        move.l  a0,d7
        beq     wide_end
        clr.l   wide_count_2(sp)
        movea.l (sp),a1
        jmp     (a1)
flat_part_left
        add.l   a4,d1
        addx.l  d5,d3
        move.l  wide_r_error_2(sp),d2
        move.l  wide_r_2(sp),d4
        movea.l wide_r_part_2(sp),a5
        move.l  wide_r_step_2(sp),d6
        bra.s   flat_line
flat_part_right
        move.l  wide_r_error_2(sp),d1
        move.l  wide_r_2(sp),d3
        movea.l wide_r_part_2(sp),a4
        move.l  wide_r_step_2(sp),d5
        bra.s   flat_right
flat_short
        jmp     flat_short_end(pc,d7.w*2)
        rept    SHORT-1
        move.b  d0,(a1)+
        endr
flat_short_end
        bra     flat_next
        endm

flat_wide macro
        edge_wide d2,d0
        add.l   a0,d6
        move.l  batch_source(a5),d0
        ifc     '\1','left'
        move.l  d6,d3
        move.l  d4,d1
        move.l  wide_r-4(sp),d4
        move.l  wide_r_error-4(sp),d2
        movea.l wide_l_part-4(sp),a4
        move.l  wide_l_step-4(sp),d5
        movea.l wide_r_part-4(sp),a5
        move.l  wide_r_step-4(sp),d6
        else
        move.l  d4,d2
        move.l  d6,d4
        move.l  wide_r-4(sp),d3
        move.l  wide_r_error-4(sp),d1
        movea.l wide_r_part-4(sp),a4
        move.l  wide_r_step-4(sp),d5
        movea.l wide_l_part-4(sp),a5
        move.l  wide_l_step-4(sp),d6
        endc
        movea.l wide_count_1-4(sp),a0
        pea     flat_part_\1(pc)
        bra     flat_line
        endm

        routine triangles_flat,a0
        triangles_open colour
        small_close
        wide_close
        triangles_set_up flat,2
        small_lines_flat left
        small_lines_flat right
        wide_lines_flat
