        include "routine.i"

; span_affine_copy - span_affine_row if u's step is one texel a pixel
;
; like:    span_affine_column
; in:      a0  span_plan*  the table, the frame, the map
; formats: U, V 8 bits, U wraps at 256; 8-bit texels and pixels. dudx is 1 texel and
;          dvdx 0, both modulo 256 and not read
; error:   none: pixel n shows texel (floor(u) + n, floor(v))

; Copies consecutive texels of the map's row, in parts up to the row's end: a longword at
; each end of a part, and longwords between, which overlap these. From ALIGNED pixels on
; the reads between are aligned, which saves more in chip RAM than it costs. In shorter
; parts it costs more, and aligned writes gain less. MOVEM is faster still, but needs more
; registers than are free: saving them takes as long as 64 pixels gain.

ALIGNED equ     48              ; pixels

        span span_affine_copy
        move.l  span_plan_map(a0),d1    ; mm00
        move.l  span_plan_pitch(a0),d6
        movea.l span_plan_row(a0),a6
        move.l  span_plan_count(a0),d7
        movea.l span_plan_lines(a0),a0
        lea     .next(pc),a5
        moveq   #0,d4
        not.b   d4                      ; 255
        moveq   #ALIGNED-9,d5
        lea     .body_end-2(pc),a3
        bra     .line

.body   rept    62
        move.l  (a2)+,(a1)+
        endr
.body_end
.ran    jmp     (a5)
.next   adda.l  d6,a6
.line   subq.w  #1,d7
        bmi.s   .done
        move.l  (a0)+,d0                ; --:left
        lea     (a6,d0.w),a1
        move.l  (a0)+,d2                ; last:Vv
        move.w  d2,d1                   ; mmVv
        swap    d2
        sub.w   d0,d2                   ; pixels - 1
        bmi.s   .empty
        move.l  (a0)+,d0
        move.b  d0,d1                   ; mmVU
        moveq   #0,d0
        move.b  d1,d0
        add.w   d2,d0                   ; U of the last pixel
.part   cmp.w   d4,d0
        bhi.s   .wraps
.run    movea.l d1,a2
        subq.w  #3,d2                   ; pixels - 4
        bmi.s   .bytes
        move.l  (a2)+,(a1)+
        move.l  -4(a2,d2.w),-4(a1,d2.w)
        subq.w  #5,d2                   ; pixels - 9
        bmi.s   .ran                    ; drawn already
        cmp.w   d5,d2
        bcs.s   .longwords
        move.w  a2,d0
        and.w   #3,d0                   ; bytes back to a boundary
        add.w   d0,d2
        suba.w  d0,a1
        suba.w  d0,a2

.longwords
        lsr.w   #2,d2                   ; longwords - 1
        neg.w   d2                      ; 2 bytes of code each
        jmp     (a3,d2.w*2)

.bytes  addq.w  #2,d2                   ; pixels - 2
        bmi.s   .one
        beq.s   .two
        move.w  (a2)+,(a1)+
.one    move.b  (a2),(a1)
        jmp     (a5)

.two    move.w  (a2),(a1)
        jmp     (a5)

.empty  addq.l  #4,a0
        bra.s   .next
.done   rts

.wraps  sub.w   #256,d0
        move.w  d0,d3                   ; pixels after the row's end - 1
        sub.w   d0,d2
        subq.w  #1,d2
        lea     1(a1,d2.w),a4           ; their address
        lea     .more(pc),a5
        bra.s   .run

        ; the next part, from the row's beginning
.more   movea.l a4,a1
        clr.b   d1
        move.w  d3,d2
        move.w  d3,d0
        lea     .next(pc),a5
        bra.s   .part
