; Perspective spans as in far.i for polygons whose K is too far away: u = S r with r = table[q].
;
; S, T and q are stepped from piece to piece; each piece begins at its own look-up, so nothing adds up. All three
; are shifted left by the same even b.
;
; \1: right if q grows to the right, or left.

        include "far.i"

; On the stack; the fields up to by_v as in a far_planes_span.
by_q            equ     0               ; at pixel -EDGE_BIAS of the line
by_dqdx         equ     4
by_dqdy         equ     8
by_s            equ     12
by_dsdx         equ     16
by_dsdy         equ     20
by_t            equ     24
by_dtdx         equ     28
by_dtdy         equ     32
by_u            equ     36              ; the bases
by_v            equ     40
by_most_16      equ     44              ; of |dqdx| in pieces of 16
by_most_8       equ     48
by_most_4       equ     52
by_most_2       equ     56
by_end          equ     60              ; of the table
by_row          equ     64              ; the line's, at pixel -EDGE_BIAS
by_pitch        equ     68
by_shift        equ     72              ; b
by_ds           equ     76              ; a piece
by_dt           equ     80
by_v0           equ     84              ; v where the piece begins, 16.16
by_bytes        equ     88

; \2 = \1 at d2 pixels from pixel -EDGE_BIAS.
by_value macro
        move.l  d2,\2
        muls.l  by_d\1dx(sp),\2
        add.l   by_\1(sp),\2
        endm

; Steps \1 to the next line. Uses d0.
by_next macro
        move.l  by_d\1dy(sp),d0
        add.l   d0,by_\1(sp)
        endm

; \1 = the base \3 + \2 r, 16.16; d2: r. Uses d0.
by_times_r macro
        move.l  \2,\1
        muls.l  d2,d0:\1
        move.w  d0,\1
        swap    \1
        add.l   by_\3(sp),\1
        endm

; by_d\1 = the step of \1 in the way that lines are drawn, 2^\3 pixels on. Uses d0; d2: b.
by_step macro
        move.l  by_d\1dx(sp),d0
        ifc     '\2','left'
        neg.l   d0
        endc
        lsl.l   d2,d0
        ifne    \3
        lsl.l   #\3,d0
        endc
        move.l  d0,by_d\1(sp)
        endm

; Pieces of 2^\2 pixels; d3: step of q a pixel.
by_pieces macro
        ifne    \2
        lsl.l   #\2,d3
        endc
        swap    d3
        movea.l d3,a4
        by_step s,\1,\2
        by_step t,\1,\2
        moveq   #0,d2
        move.w  (a3,d5.w*2),d2
        by_times_r d3,d6,u
        movea.l d3,a5
        by_times_r d3,d7,v
        move.l  d3,by_v0(sp)
.piece\2
        add.l   a4,d5
        moveq   #0,d2
        addx.w  d2,d5
        move.w  (a3,d5.w*2),d2
        add.l   by_ds(sp),d6
        add.l   by_dt(sp),d7
        by_times_r d3,d6,u
        by_times_r d1,d7,v
        move.l  d3,d2
        sub.l   a5,d2
        lsl.l   #8-(\2),d2
        move.l  a5,d0
        movea.l d3,a5
        movea.l by_v0(sp),a2
        move.l  d1,by_v0(sp)
        move.l  d1,d3
        sub.l   a2,d3
        lsl.l   #8-(\2),d3
        move.l  a2,d1
        swap    d0                      ; uu-U
        lsl.l   #8,d1
        swap    d1                      ; v-Vv
        move.b  d0,d4
        move.w  d1,d0                   ; uuVv
        clr.w   d1
        move.b  d4,d1                   ; v--U
        rol.l   #8,d2                   ; uuuU
        swap    d3                      ; vvVv
        far_rest \1
        cmp.w   #-(1<<\2),d4
        bge     .last\2
        far_steps
        rept    (1<<\2)-1
        far_pixel l,\1
        endr
        far_pixel w,\1
.pixels\2
        tst.w   d5
        bmi     .piece\2
        cmpa.l  a6,a1
        bne     .over
        bra     .below

.last\2 moveq   #0,d5                   ; no further piece
        lea     .pixels\2(pc,d4.w*4),a2
        lea     (a2,d4.w*8),a2          ; 12 bytes a pixel
        far_steps
        jmp     (a2)
        endm

; Draws the table of the span in a0.
by_lines macro
        move.l  far_planes_span_count(a0),d0
        movea.l far_planes_span_lines(a0),a1
        lsl.l   #2,d0
        lea     (a1,d0.l),a2
        lea     (a2,d0.l*2),a2
        lea     -by_bytes(sp),sp
        move.l  a2,by_end(sp)
        move.l  far_planes_span_row(a0),by_row(sp)
        move.l  far_planes_span_pitch(a0),by_pitch(sp)
        movem.l far_planes_span_q(a0),d0-d7/a1-a3
        movem.l d0-d7/a1-a3,by_q(sp)
        movea.l far_planes_span_lengths(a0),a1
        movem.l (a1),d0-d3
        movem.l d0-d3,by_most_16(sp)
        move.l  far_planes_span_map(a0),d4      ; mm00
        movea.l far_planes_span_table(a0),a3
        movea.l far_planes_span_lines(a0),a0

        ; a0 line  a1 pixel  a6 the line's end  a4 step of q  a5 u where the piece begins, 16.16
        ; d4 mm00  d5 q, its index less 2^15  d6 S  d7 T
.line   move.l  (a0)+,d0                ; start0:left
        move.w  (a0)+,d1                ; last
        addq.l  #6,a0
        movea.l by_row(sp),a2
        move.w  d1,d3
        sub.w   d0,d3
        bmi     .below
        addq.w  #1,d3
        moveq   #0,d2
        ifc     '\1','right'
        move.w  d0,d2
        lea     (a2,d2.l),a1
        else
        move.w  d1,d2
        lea     1(a2,d2.l),a1
        neg.w   d3
        endc
        lea     (a1,d3.w),a6
        by_value q,d5
        by_value s,d6
        by_value t,d7
        bfffo   d5{1:31},d2
        subq.l  #1,d2
        and.w   #-2,d2
        lsl.l   d2,d5
        lsl.l   d2,d6
        lsl.l   d2,d7
.begun  move.l  d2,by_shift(sp)
        move.l  by_dqdx(sp),d3
        ifc     '\1','left'
        neg.l   d3
        endc
        lsl.l   d2,d3
        bchg    #31,d5
        swap    d5
        cmp.l   by_most_16(sp),d3
        bhi     .under_16
        by_pieces \1,4
.under_16
        cmp.l   by_most_8(sp),d3
        bhi     .under_8
        by_pieces \1,3
.under_8
        cmp.l   by_most_4(sp),d3
        bhi     .under_4
        by_pieces \1,2
.under_4
        cmp.l   by_most_2(sp),d3
        bhi     .under_2
        by_pieces \1,1
.under_2
        by_pieces \1,0

.over   swap    d5
        bchg    #31,d5
        lsr.l   #2,d5
        asr.l   #2,d6
        asr.l   #2,d7
        move.l  by_shift(sp),d2
        subq.l  #2,d2
        bra     .begun

.below  move.l  by_pitch(sp),d0
        add.l   d0,by_row(sp)
        by_next q
        by_next s
        by_next t
        cmpa.l  by_end(sp),a0
        bne     .line
        lea     by_bytes(sp),sp
        rts
        endm
