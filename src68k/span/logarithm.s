        include "routine.i"

; span_logarithm - draws lines with perspective, each pixel by logarithms
;
; in:      a0  logarithm_span*  the lines, the frame, the map, the tables
; reads:   the span, its lines, both tables, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.8, both wrap at 256; 8-bit texels and pixels. q's index steps in 16.16,
;          its overflow enters its fraction
; error:   of a power 1/512 texel, of u's and v's distance from K half a unit of logs and one
;          part in twice the index; errors of q, C and K: see logarithm_lines
; cost:    bench row persp_pixel

; On the stack.
row     equ     0
pitch   equ     4
powers  equ     8
left    equ     12                      ; lines

; d0 q  d1 Ku  d2 step of q  d3 Kv  d6 page of the map  d7 0  a1 pixel  a2 logs
; a3, a4 powers of u and v, at a logarithm of 0  a6 after the last pixel
pixel   macro
        move.w  d1,d5
        move.w  d3,d6
        move.w  (a2,d0.w*2),d4
        add.l   d2,d0
        addx.w  d7,d0
        \1.w    (a3,d4.w*2),d5          ; UUuu
        \2.w    (a4,d4.w*2),d6          ; mmVv
        lsr.w   #8,d5
        move.b  d5,d6                   ; mmVU
        movea.l d6,a5
        move.b  (a5),(a1)+              ; the write overlaps with the next pixel's K
        endm

PIXEL   equ     28                      ; bytes of its code

; The loop with \1 for u and \2 for v, add or sub; \3 its label.
pixels  macro
        cnop    0,4
\3
        rept    8
        pixel   \1,\2
        endr
        cmpa.l  a6,a1
        bne     \3
        bra     .next
        endm

; The places in the loop \1 of the pixel counts less one, modulo 8, from .entries.
entries macro
        rept    8
        dc.w    \1-.entries+(7-REPTN)*PIXEL
        endr
        endm

        routine span_logarithm,a0
        movem.l d2-d7/a2-a6,-(sp)
        move.l  logarithm_span_count(a0),-(sp)
        move.l  logarithm_span_powers(a0),-(sp)
        move.l  logarithm_span_pitch(a0),-(sp)
        move.l  logarithm_span_row(a0),-(sp)
        move.l  logarithm_span_map(a0),d6
        movea.l logarithm_span_logs(a0),a2
        movea.l logarithm_span_lines(a0),a0

.line   move.l  (a0)+,d7                ; left:n
        tst.w   d7
        bmi.s   .empty
        movem.l (a0)+,d0/d2-d3/a3-a4
        move.l  d3,d1
        swap    d1
        move.l  powers(sp),d4
        adda.l  d4,a3
        adda.l  d4,a4
        moveq   #7,d5
        and.w   d7,d5
        move.w  (a0)+,d4                ; way
        addq.l  #2,a0
        lsl.w   #3,d4
        or.w    d5,d4
        move.w  .entries(pc,d4.w*2),d5
        movea.l row(sp),a1
        move.l  d7,d4
        swap    d4
        adda.w  d4,a1
        lea     1(a1,d7.w),a6
        moveq   #0,d7
        jmp     .entries(pc,d5.w)

.empty  lea     logarithm_line_sizeof-4(a0),a0
.next   move.l  pitch(sp),d7
        add.l   d7,row(sp)
        subq.l  #1,left(sp)
        bne.s   .line
        lea     16(sp),sp
        movem.l (sp)+,d2-d7/a2-a6
        rts

; By way and the count of pixels less one, modulo 8.
.entries
        entries .add_add
        entries .sub_add
        entries .add_sub
        entries .sub_sub

        pixels  add,add,.add_add
        pixels  sub,add,.sub_add
        pixels  add,sub,.add_sub
        pixels  sub,sub,.sub_sub
