        include "chain.i"
        include "triangle_lines.i"

; triangles_affine - draws a batch of triangles from a 256x256 map
;
; in:      a0  triangle_plan*  the list, the frame, the map, the reciprocals
; out:     d0  triangle*  the first triangle that was not drawn: the list's end, or one with a
;                         vertex out of range, or of SNAPPED_LINES lines or more
; reads:   the plan, its list, the vertices' x, y, u, v, the reciprocals, the map
; writes:  pixels
; formats: vertices in 12.4, u and v in 12.20; steps a pixel and a line 16.16; u and v of a
;          pixel 8.16, both wrap at 256 any number of times; 8-bit texels
; error:   coverage: none for the snapped vertices. u and v: 0 to 1/64 texel above the exact
;          ones where steps are below 3 texels a pixel, 1/48 in SNAPPED_TALL lines or more;
;          tools/tmap/ideal/bounds_snapped.py
; cost:    bench rows polygon_affine

; A line's pixels step B and A, the chain of span_affine_addx. So do lines: u counts how often v
; wraps, by 1/65536 texel each time. B in d0, A in d1, their steps a pixel in d2 and d3, a line in
; d7 and a5, those of the line's first pixel in a3 and a4; d4 is mm00.

affine_unrolled equ     16

affine_zero macro
        clr.w   d4
        endm

; \1: a register whose lowest byte is 0.
affine_line macro
        move.l  a4,d1
        add.l   a5,d1
        move.l  a3,d0
        addx.l  d7,d0
        addx.b  \1,d1
        endm

affine_keep macro
        movea.l d0,a3
        movea.l d1,a4
        endm

affine_more_left macro
        add.l   d3,d1
        addx.l  d2,d0
        addx.b  \1,d1
        endm

affine_more_right macro
        sub.l   d3,d1
        subx.l  d2,d0
        subx.b  \1,d1
        endm

affine_pixel_left macro
        texel_next d2,d3
        movea.l d4,a2
        move.b  (a2),(a1)+
        endm

affine_pixel_right macro
        texel_next d2,d3
        movea.l d4,a2
        move.b  (a2),-(a1)
        endm

; Goes to the -d4 pixels before the label \1.
affine_enter macro
        lea     \1(pc,d4.w*4),a2
        add.l   d3,d1
        jmp     (a2,d4.w*8)
        endm

; A line's pixels in a triangle of the class \2.
affine_block macro
affine_\2_\1
        ifc     '\2','narrow'
        rept    32
        affine_pixel_\1
        endr
affine_\2_end_\1
        else
        rept    16
        affine_pixel_\1
        endr
affine_\2_end_\1
        cmpa.l  a6,a1
        bne     affine_\2_\1
        endc
        endm

; Goes to the line's pixels, of which the first round has those that whole rounds leave, 0 to 15: d4
; becomes one below minus their number.
affine_go macro
        subq.w  #1,d4
        or.w    #-16,d4
        affine_enter affine_\2_end_\1+12
        endm

affine_begin macro
        move.l  wide_r_error(sp),d6
        movea.l wide_r(sp),a6
        endm

; The short edges' fractions have 24 bits as well: d6's lowest byte stays 0.
affine_counted macro
        move.b  #1,wide_l_part+3(sp)
        clr.b   wide_r_part+3(sp)
        clr.b   wide_r_part_2+3(sp)
        endm

affine_short macro
        adda.l  wide_r_step(sp),a6
        add.l   wide_r_part(sp),d6
        bcc.s   .stepped\@
        addq.l  #1,a6
.stepped\@
        endm

affine_second macro
        move.l  wide_r_step_2(sp),wide_r_step(sp)
        move.l  wide_r_part_2(sp),wide_r_part(sp)
        movea.l wide_r_2(sp),a6
        move.l  wide_r_error_2(sp),d6
        endm

; Packs the starts a6 and a3, the steps a pixel a4 and a2, the steps a line (sp)+ and d7.
affine_pack macro
        move.l  a6,d0
        move.l  a3,d3
        pack_apart d0,d3,d1
        move.l  a4,d2
        move.l  a2,d4
        pack_step_apart d2,d4,d3
        sub.b   d3,d1                   ; the first pixel's addition adds it again
        ifc     '\1','right'
        bset    #23,d1                  ; what is subtracted from U does not reach v
        endc
        move.l  (sp)+,d5
        pack_step_apart d5,d7,d4
        move.l  batch_source(a5),d7
        movea.l d4,a5
        move.l  d7,d4
        move.l  d5,d7
        endm

; Narrow triangles have a line's number of pixels in place of their short edge S: d6 is -S if it is the
; right one, else S, 24 bits of fraction above a byte of whole pixels. That byte counts from the long
; edge's pixel, and is two below minus the number, so it stays below 0: adding a step, in a6, carries
; into the fraction where the step's byte is below 0, and only there, which the step allows for. The
; fraction's own carry is added to the byte after that.

; Sets a6 and d6 for the short edge whose fields' names end in \2. Uses d4's lower word.
narrow_edge macro
        move.l  wide_r_part\2(sp),d6
        clr.b   d6
        ifc     '\1','left'
        neg.l   d6
        move.b  wide_r_step\2+3(sp),d4
        subx.b  d4,d6
        add.b   wide_l_step+3(sp),d6
        else
        move.b  wide_r_step\2+3(sp),d6
        sub.b   wide_l_step+3(sp),d6
        endc
        bpl.s   .rises\@
        sub.l   #$100,d6                ; what its byte will carry
        bcc.s   .rises\@
        subq.b  #1,d6
.rises\@
        movea.l d6,a6
        move.l  wide_r_error\2(sp),d6
        ifc     '\1','left'
        not.l   d6
        move.w  a0,d4
        sub.w   wide_r\2+2(sp),d4
        else
        move.w  wide_r\2+2(sp),d4
        sub.w   a0,d4
        endc
        subq.b  #2,d4
        move.b  d4,d6
        move.w  #$ff00,d4
        endm

; Steps the short edge; d4's lowest byte is 0 then.
narrow_step macro
        move.w  #$ff00,d4
        add.l   a6,d6
        addx.b  d4,d6
        endm

narrow_go macro
        affine_keep
        move.b  d6,d4
        movea.l a0,a1
        affine_enter affine_narrow_end_\1+24
        endm

narrow_lines macro
        cnop    0,4
        affine_block \1,narrow
        tst.b   d5
        beq.s   narrow_part_\1
        adda.l  wide_l_step(sp),a0
        add.l   wide_l_part(sp),d5
        bcs.s   narrow_more_\1
        narrow_step
narrow_line_\1
        affine_line d4
narrow_first_\1
        narrow_go \1
narrow_more_\1
        addq.l  #1,a0
        narrow_step
        ifc     '\1','left'
        addq.b  #1,d6
        else
        subq.b  #1,d6
        endc
        affine_line d4
        affine_more_\1 d4
        narrow_go \1
narrow_part_\1
        move.b  wide_count_2+3(sp),d5
        beq     wide_end
        neg.b   d5
        clr.l   wide_count_2(sp)
        adda.l  wide_l_step(sp),a0
        add.l   wide_l_part(sp),d5
        bcc.s   .edge\@
        addq.l  #1,a0
        clr.w   d4
        move.l  a4,d1
        move.l  a3,d0
        affine_more_\1 d4
        affine_keep
.edge\@ narrow_edge \1,_2
        bra     narrow_line_\1
        endm

affine_narrow_counted macro
        move.b  #1,wide_l_part+3(sp)
        endm

affine_narrow macro
        lines_counted affine_narrow
        narrow_edge \1
        bra     narrow_first_\1
        endm

affine_small macro
        texel_gradients SLIVER_SMALL,small_\1
        move.l  a2,d4
        moveq   #15,d5
        long_small \1
        move.l  a2,-(sp)
        movea.l d4,a2
        value_start snapped_vertex_u,a6,a4,a6
        move.l  d7,-(sp)
        value_start snapped_vertex_v,a3,a2,a3
        affine_pack \1
        movea.l (sp)+,a6
        move.l  (sp)+,d5
        move.l  (sp)+,d6
        bra     small_first_\1
        texel_slivers small_\1
        endm

affine_wide macro
        texel_gradients SLIVER_WIDE,wide_\1
        moveq   #15,d5
        long_wide \1
        value_start_wide snapped_vertex_u,a6,a4,a6
        move.l  d7,-(sp)
        value_start_wide snapped_vertex_v,a3,a2,a3
        affine_pack \1
        move.l  (sp)+,d5
        wide_begin \1,affine
        texel_slivers wide_\1
        endm

        routine triangles_affine,a0
        triangles_open map
texel_quotient
        triangle_quotient
        small_close
        wide_close
        triangles_set_up affine,1,2
        small_lines left,affine,d4,(sp),small_step(sp)
        small_lines right,affine,d4,(sp),small_step(sp)
        narrow_lines left
        narrow_lines right
        wide_lines left,affine,wide,wide_l_part(sp),wide_l_step(sp),a6,d4,d6
        wide_lines right,affine,wide,wide_l_part(sp),wide_l_step(sp),a6,d4,d6
        wide_lines left,affine,tall,wide_l_part(sp),wide_l_step(sp),a6,d4,d4
        wide_lines right,affine,tall,wide_l_part(sp),wide_l_step(sp),a6,d4,d4
