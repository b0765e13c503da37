        include "triangle_table.i"

; triangle_lines_flat - the scanline table of a batch's next triangle, without u and v
;
; in:      a0  triangle_plan*  the list, the frame, the reciprocals; its span's lines and pitch
; out:     d0  triangle*  behind the triangle whose lines these are. If the span's count is 0: the
;                         first triangle that was not drawn, or the list's end
; reads:   the plan, its list, the vertices' x and y, the reciprocals
; writes:  of the span: lines (left and last), count; row if there are lines
; formats: vertices in 12.4; x with EDGE_BIAS
; error:   none for the snapped vertices
; cost:    bench rows triangle_lines_flat

; The line at a1: left x in a3, its error d5, part a4 and whole a2; one right of the right x in a6,
; its error d6, part a0, whole d7.

; Steps a side: \1 its x, \2 whole, \3 error, \4 part.
side    macro
        adda.l  \2,\1
        add.l   \4,\3
        bcc.s   .stepped\@
        addq.l  #1,\1
.stepped\@
        endm

; The lines, down to the middle vertex and from there on; long edge on the side \1.
outline_lines macro
.line\@ addq.l  #2,a1
        move.w  a3,(a1)+                ; left
        move.w  a6,(a1)+                ; last
        addq.l  #6,a1
        subq.l  #1,(sp)
        beq.s   .part\@
        side    a3,a2,d5,a4
        side    a6,d7,d6,a0
        bra.s   .line\@
.part\@ move.l  wide_count_2(sp),(sp)
        beq     table_end
        clr.l   wide_count_2(sp)
        ifc     '\1','left'
        side    a3,a2,d5,a4
        move.l  wide_r_step_2(sp),d7
        movea.l wide_r_part_2(sp),a0
        movea.l wide_r_2(sp),a6
        subq.l  #1,a6
        move.l  wide_r_error_2(sp),d6
        else
        side    a6,d7,d6,a0
        movea.l wide_r_step_2(sp),a2
        movea.l wide_r_part_2(sp),a4
        movea.l wide_r_2(sp),a3
        move.l  wide_r_error_2(sp),d5
        endc
        bra.s   .line\@
        endm

outline_wide macro
        moveq   #15,d5
        long_wide \1
        table_begin 0
        ifc     '\1','left'
        movea.l a0,a3
        move.l  (sp),d5
        movea.l wide_l_part(sp),a4
        movea.l wide_l_step(sp),a2
        movea.l wide_r(sp),a6
        move.l  wide_r_error(sp),d6
        movea.l wide_r_part(sp),a0
        move.l  wide_r_step(sp),d7
        else
        movea.l a0,a6
        move.l  (sp),d6
        movea.l wide_l_part(sp),a0
        move.l  wide_l_step(sp),d7
        movea.l wide_r(sp),a3
        move.l  wide_r_error(sp),d5
        movea.l wide_r_part(sp),a4
        movea.l wide_r_step(sp),a2
        endc
        subq.l  #1,a6
        move.l  wide_count_1(sp),(sp)
        outline_lines \1
        endm

        routine triangle_lines_flat,a0
        table_open
        table_close
        table_set_up outline
