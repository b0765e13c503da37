        include "triangle_wide.i"

; triangles_flat - draws a batch of triangles in one colour
;
; in:      a0  triangle_plan*  the list, the frame, the colour, the reciprocals
; out:     d0  triangle*  as triangles_affine
; reads:   the plan, its list, the vertices' x and y, the reciprocals
; writes:  pixels
; formats: vertices in 12.4; 8-bit chunky pixels, four of them in colour
; error:   none for the snapped vertices
; cost:    bench rows polygon_flat

; d0 is the colour. Of a wide triangle's edges d7 and a5 are part and step of the long one, a4 and a2
; of the short one.

flat_unrolled   equ     32
SHORT           equ     12              ; fewer pixels are filled byte by byte

flat_line macro
        endm

flat_keep macro
        endm

flat_more_left macro
        endm

flat_more_right macro
        endm

flat_pixel_left macro
        move.b  d0,(a1)+
        endm

flat_pixel_right macro
        move.b  d0,-(a1)
        endm

flat_enter macro
        jmp     flat_end_\1(pc,d4.w*2)
        endm

; Fills -d4 pixels at a1: short lines by bytes, others by longwords at a boundary. Uses d1/d3.
flat_rounds_left macro
        flat_fill left
        endm

flat_rounds_right macro
        flat_fill right
        endm

flat_fill macro
        rept    SHORT
        move.b  d0,(a1)+
        endr
flat_bytes_end_\1
        bra     wide_next_\1
flat_long_\1
        neg.w   d4
        move.w  a1,d3
        btst    #0,d3
        beq.s   .even\@
        move.b  d0,(a1)+
        subq.w  #1,d4
        addq.w  #1,d3
.even\@ btst    #1,d3
        beq.s   .aligned\@
        move.w  d0,(a1)+
        subq.w  #2,d4
.aligned\@
        move.w  d4,d3
        lsr.w   #2,d3
        move.w  d3,d1
        and.w   #15,d1
        neg.w   d1
        lsr.w   #4,d3
        jmp     .longwords_end\@(pc,d1.w*2)
.longwords\@
        rept    16
        move.l  d0,(a1)+
        endr
.longwords_end\@
        dbra    d3,.longwords\@
        btst    #1,d4
        beq.s   .last\@
        move.w  d0,(a1)+
.last\@ btst    #0,d4
        beq.s   .filled\@
        move.b  d0,(a1)+
.filled\@
        endm

flat_enter_wide macro
        ifc     '\1','right'
        movea.l a6,a1
        endc
        cmp.w   #-SHORT,d4
        blt     flat_long_\1
        jmp     flat_bytes_end_\1(pc,d4.w*2)
        endm

flat_small macro
        edge_small d2,d0
        movea.l d4,a6
        move.l  d3,d5
        move.l  batch_source(a5),d0
        move.l  (sp)+,d6
        bra     small_first_\1
        endm

flat_wide macro
        edge_wide d2,d0
        adda.l  d6,a0
        move.l  batch_source(a5),d0
        move.l  d4,d5
        move.l  wide_r_error-4(sp),d6
        movea.l wide_r-4(sp),a6
        move.l  wide_l_part-4(sp),d7
        movea.l wide_l_step-4(sp),a5
        movea.l wide_r_part-4(sp),a4
        movea.l wide_r_step-4(sp),a2
        move.l  wide_count_1-4(sp),-(sp)
        bra     wide_first_\1
        endm

        routine triangles_flat,a0
        triangles_open colour
        small_close
        wide_close
        triangles_set_up flat,2
        small_lines left,flat
        small_lines right,flat
        wide_lines left,flat,d7,a5,a4,a2
        wide_lines right,flat,d7,a5,a4,a2
