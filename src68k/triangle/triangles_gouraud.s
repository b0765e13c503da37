        include "triangle_lines.i"

; triangles_gouraud - draws a batch of triangles, shade by shade
;
; in:      a0  triangle_plan*  the list, the frame, the reciprocals
; out:     d0  triangle*  as triangles_affine
; reads:   the plan, its list, the vertices' x, y, u, the reciprocals
; writes:  pixels
; formats: vertices in 12.4, shades as u in 12.20, 0 to 256; a pixel is its shade's integer; steps
;          16.16, 0 where a step a pixel is SHADES_STEEP or more
; error:   coverage: none for the snapped vertices. Shades: as u of triangles_affine
; cost:    bench rows polygon_gouraud

; A shade is one chain, ss--SS with the integer in the lower word: its carry is added to its own lowest
; bit, so that adding steps a pixel or a line, in any order, is exact: modulo 2^32 - 1 the chain is
; the shade times 2^16. A negative step is one less before its halves are swapped. d0 is the shade,
; d2 its step a pixel, a4 that step's fraction, a3 the line's first shade, d4 0.
;
; Small: d7 is its step a line, d1 the lines left, a2 the short edge's step; d3 counts pixels.
;
; Not small: a2 and a5 are part and step of the long edge, d1 is the short one's pixel, a6 and d3 its
; part and step; d7 counts pixels.

gouraud_unrolled equ    32

gouraud_step    equ     wide_r_error    ; the step a line, on the stack

gouraud_zero macro
        endm

; \1: a register that is 0, \2: small or not.
gouraud_line macro
        move.l  a3,d0
        ifc     '\2','small'
        add.l   d7,d0
        else
        add.l   gouraud_step(sp),d0
        endc
        addx.l  \1,d0
        endm

gouraud_keep macro
        movea.l d0,a3
        endm

gouraud_more_left macro
        add.l   d2,d0
        addx.l  \1,d0
        endm

gouraud_more_right macro
        sub.l   d2,d0
        subx.l  \1,d0
        endm

; The fraction is a step ahead, so that its carry is ready when the integer is stepped.
gouraud_pixel_left macro
        move.b  d0,(a1)+
        addx.l  d2,d0
        endm

gouraud_pixel_right macro
        move.b  d0,-(a1)
        addx.l  d2,d0
        endm

; Goes to the -\2 pixels before the label \1.
gouraud_enter macro
        add.l   a4,d0
        jmp     \1(pc,\2.w*4)
        endm

; A line's pixels in a triangle of the class \2.
gouraud_block macro
gouraud_\2_\1
        ifc     '\2','narrow'
        rept    64
        gouraud_pixel_\1
        endr
gouraud_\2_end_\1
        else
        rept    32
        gouraud_pixel_\1
        endr
gouraud_\2_end_\1
        cmpa.l  d1,a1
        bne     gouraud_\2_\1
        endc
        endm

; Goes to the line's pixels. Unless the triangle is narrow, the first round has those that whole rounds
; leave, 0 to 31: d7 becomes one below minus their number.
gouraud_go macro
        ifc     '\2','narrow'
        gouraud_enter gouraud_\2_end_\1,d7
        else
        subq.w  #1,d7
        or.w    #-32,d7
        gouraud_enter gouraud_\2_end_\1+4,d7
        endc
        endm

gouraud_counted macro
        move.l  a2,d7
        move.b  #1,d7
        movea.l d7,a2
        endm

gouraud_narrow macro
        lines_counted gouraud
        bra     narrow_first_\1
        endm

gouraud_begin macro
        endm

gouraud_short macro
        add.l   a6,d6
        addx.l  d3,d1
        endm

gouraud_second macro
        move.l  wide_r_step_2(sp),d3
        movea.l wide_r_part_2(sp),a6
        move.l  wide_r_2(sp),d1
        move.l  wide_r_error_2(sp),d6
        endm

; a4 = the shade's step a pixel, not a whole negative number; a6 = its difference along the long edge.
gouraud_gradient macro
        move.l  a6,d6
        move.w  d2,d3
        ext.l   d3
        ext.l   d1
        cmp.l   #\1,d6
        bls.s   .sliver\@
        gradient snapped_vertex_u,a6
        bra.s   .found\@
.sliver\@
        gradient snapped_vertex_u,a6,gouraud_quotient
.found\@
        move.l  d4,d0
        add.l   #SHADES_STEEP<<16,d0
        cmp.l   #SHADES_STEEP<<17,d0
        bcs.s   .flat\@
        moveq   #0,d4
.flat\@ tst.w   d4                      ; a whole negative step has no fraction that
        bne.s   .part\@                 ; can be ahead: it gets one
        tst.l   d4
        minus   <subq.l #1,d4>
.part\@ movea.l d4,a4
        moveq   #15,d5
        endm

; Packs the start a6 and the steps a4 a pixel and d7 a line.
gouraud_pack macro
        move.l  a6,d0
        minus   <subq.l #1,d0>
        swap    d0
        move.l  a4,d2
        swap    d2
        move.l  d2,d4
        clr.w   d4
        tst.w   d2
        minus   <sub.l #$10000,d2>
        movea.l d4,a4
        tst.l   d7
        minus   <subq.l #1,d7>
        swap    d7
        moveq   #0,d4
        endm

gouraud_small macro
        gouraud_gradient SLIVER_SMALL
        long_small \1
        move.l  a2,-(sp)
        value_start snapped_vertex_u,a6,a4,a6
        gouraud_pack
        movea.l (sp)+,a6
        move.l  (sp)+,d5
        move.l  (sp)+,d6
        move.l  small_count(sp),d1
        movea.l small_step(sp),a2
        bra     small_first_\1
        endm

gouraud_wide macro
        gouraud_gradient SLIVER_WIDE
        long_wide \1
        value_start_wide snapped_vertex_u,a6,a4,a6
        gouraud_pack
        move.l  (sp)+,d5
        move.l  wide_r_error-4(sp),d6
        move.l  d7,gouraud_step-4(sp)
        move.l  wide_r-4(sp),d1
        movea.l wide_l_part-4(sp),a2
        movea.l wide_r_part-4(sp),a6
        move.l  wide_r_step-4(sp),d3
        movea.l wide_l_step-4(sp),a5
        wide_begin \1,gouraud
        endm

        routine triangles_gouraud,a0
        triangles_open
gouraud_quotient
        triangle_quotient
        small_close
        wide_close
        triangles_set_up gouraud,2,4
        small_lines left,gouraud,d3,d1,a2
        small_lines right,gouraud,d3,d1,a2
        wide_lines left,gouraud,narrow,a2,a5,d1,d7,d4
        wide_lines right,gouraud,narrow,a2,a5,d1,d7,d4
        wide_lines left,gouraud,wide,a2,a5,d1,d7,d4
        wide_lines right,gouraud,wide,a2,a5,d1,d7,d4
        wide_lines left,gouraud,tall,a2,a5,d1,d7,d4
        wide_lines right,gouraud,tall,a2,a5,d1,d7,d4
