        include "n64.i"

; n64_threepoint_yuv - colours of YUV texels, luma and chroma by the three-point filter
;
; in:      a0  const n64_coordinates*  relative coordinates
;          a1  uint32*  colours, R G B A
;          a2  const n64_yuv_filter*  the tile, with quads of luma and of chroma; tables
; formats: s:t, both s10.5 modulo 2^16; chroma's as of n64_chroma; 9 bits each of R, G, B and A = Y are
;          the indices of the colours' channels

; Both quads have the same index. Of luma's, A is Y; of chroma's, G is V and A is U, so that a part of
; n64_weights makes both in d3.

; On the stack.
matrix  equ     0
of_v    equ     4
colours equ     8
end     equ     12
locals  equ     16

        xref    n64_weights_ga_table

; Makes d3 = G-A- of the quad a2 and goes on at \1. In: d1 of the table, for the fractions. Uses d0-d1.
weigh   macro
        lea     \1(pc),a3
        adda.w  d1,a2
        swap    d1
        jmp     (a5,d1.w)
        endm

        pass    n64_threepoint_yuv
        save_all
        lea     -locals(sp),sp
        lea     (a0,d0.l*4),a6
        move.l  a6,end(sp)
        move.l  n64_yuv_filter_colours(a2),colours(sp)
        movea.l n64_yuv_filter_matrix(a2),a6
        move.l  a6,matrix(sp)
        lea     n64_matrix_v(a6),a6
        move.l  a6,of_v(sp)
        move.l  n64_yuv_filter_mask_s(a2),d6    ; and mask_t
        move.w  n64_yuv_filter_columns_bits(a2),d5
        movea.l n64_yuv_filter_luma(a2),a4
        movea.l n64_yuv_filter_chroma(a2),a6
        move.l  #$003f001f,d4
        lea     n64_weights_ga_table,a5
.pixels move.l  (a0)+,d0                ; s:t
        moveq   #0,d2
        move.l  d0,d1
        and.l   d6,d0
        and.l   d4,d1
        n64_index
        move.l  d1,d7
        lea     (a4,d2.l*2),a2
        swap    d7
        lsl.w   #4,d7
        move.w  d7,d0
        and.w   #31<<5,d7
        add.w   d0,d0
        or.w    d1,d7                   ; chroma's fractions
        and.w   #31<<5,d0
        or.w    d1,d0
        move.l  (a5,d0.w*4),d1
        weigh   .luma
.luma   lea     (a6,d2.l*2),a2
        move.l  (a5,d7.w*4),d1
        move.w  d3,d7                   ; Y-
        weigh   .chroma
.chroma movem.l (sp),a2-a3
        move.w  d3,d1
        swap    d3
        lsr.w   #8,d1                   ; U
        lsr.w   #8,d3                   ; V
        move.l  (a2,d1.w*4),d2
        lsr.w   #8,d7                   ; Y
        move.w  d2,d1
        add.l   (a3,d3.w*4),d2
        movea.l colours(sp),a2
        move.w  d2,d3
        swap    d2
        sub.w   d1,d3
        move.w  #511,d0
        lsr.w   #7,d2
        add.w   d7,d3                   ; R
        add.w   d7,d2                   ; G
        add.w   d7,d1                   ; B
        and.w   d0,d3
        and.w   d0,d2
        and.w   d0,d1
        move.b  (a2,d3.w*4),d0
        lsl.w   #8,d0
        move.b  1(a2,d2.w*4),d0
        swap    d0
        move.b  2(a2,d1.w*4),d0
        lsl.w   #8,d0
        move.b  3(a2,d7.w*4),d0
        move.l  d0,(a1)+
        cmpa.l  end(sp),a0
        bne     .pixels
        lea     locals(sp),sp
        return_all
