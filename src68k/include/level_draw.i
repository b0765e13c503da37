; Draws lines of one depth each as level_reciprocal makes them, and each as soon as it is made.
;
; \1: right for lines of the frame, or down for columns.

        include "level_reciprocal.i"

        xref    inverse_begin

; On the stack, behind what inverse_begin has found.
draw_end        equ     inverse_sizeof          ; of the table
draw_cut        equ     inverse_sizeof+4        ; 2^shift - 1
draw_step       equ     inverse_sizeof+8        ; bytes to the next line's first pixel, if C's step is inverse_step,
draw_more       equ     inverse_sizeof+12       ; and if it is inverse_more
draw_pitch      equ     inverse_sizeof+16
draw_still      equ     inverse_sizeof+20       ; 0 if columns' u has no step, or lines' v
draw_sizeof     equ     inverse_sizeof+24

ROUND_right     equ     4                       ; log2 of a round's pixels
ROUND_down      equ     3

; The steps of C of \1, u or v, to lines whose x is d1 further right than the last one's, and C = \2 of the first of
; them. a2: the stack. Uses d2.
turn_c  macro
        move.l  inverse_\1+inverse_dc(a2),d2
        muls.l  d1,d2
        move.l  d2,inverse_\1+inverse_step(a2)
        adda.l  d2,\2
        add.l   inverse_\1+inverse_dc(a2),d2
        move.l  d2,inverse_\1+inverse_more(a2)
        endm

; d6 = -(pixels of the short first round - 1), d7 = rounds - 1, from pixels less one in d7.
rounds  macro
        moveq   #(1<<ROUND_\1)-1,d6
        or.w    d7,d6
        sub.w   d7,d6
        lsr.w   #ROUND_\1,d7
        endm

; The loop over lines. \2: uv, or the one of u and v that alone has a step.
        ; a0 line  a1 pixel  a3 right: K of u, down: the pitch  a4 C of u  a5 C of v  a6 the first pixel
        ; d4 mm--  d5 and d7's upper word q  d7 pixels less one
lines_loop macro
.first\2
        sub.w   d0,d1
        neg.w   d1
        bra.s   .at\2
.line\2 move.l  (a0)+,d0                ; start0:left
        move.w  (a0)+,d7                ; last
        move.w  d0,d1
        sub.w   scanline_left-scanline_start1-scanline_sizeof(a0),d1
        sub.w   inverse_whole+2(sp),d1
.at\2   bne     .more\2
        adda.l  inverse_u+inverse_step(sp),a4
        adda.l  inverse_v+inverse_step(sp),a5
        adda.l  draw_step(sp),a6
.go\2   addq.l  #scanline_sizeof-scanline_start1,a0
        sub.w   d0,d7
        bmi     .next\2

        ; d2 R; u and v
        move.l  draw_cut(sp),d1
        moveq   #-1,d2
        divu.l  d5,d1:d2
        move.l  a4,d1
        muls.l  d2,d0:d1
        ifc     '\1','right'
        add.l   a3,d0
        else
        add.l   inverse_u+inverse_k(sp),d0
        endc
        move.l  a5,d1
        muls.l  d2,d3:d1
        add.l   inverse_v+inverse_k(sp),d3
        line_\2 \1
.next\2 add.l   inverse_dq+number64_lo(sp),d7
        move.l  inverse_dq(sp),d0
        addx.l  d0,d5
        cmpa.l  draw_end(sp),a0
        bne     .line\2
        moveq   #1,d0
        bra     .done

.more\2 subq.w  #1,d1
        bne.s   .turn\2
        adda.l  inverse_u+inverse_more(sp),a4
        adda.l  inverse_v+inverse_more(sp),a5
        adda.l  draw_more(sp),a6
        bra     .go\2

.turn\2 bsr     .turned
        bra     .go\2
        endm

; The pixels of a line whose u and v are d0 and d3.
line_uv macro
        moveq   #0,d1
        move.b  d3,d1
        ror.l   #8,d1                   ; v---
        lsr.l   #8,d3                   ; .Vv
        swap    d0                      ; uuUU
        move.b  d0,d1                   ; v--U
        move.w  d3,d0                   ; uuVv

        ; their steps, as chain_steps, in d3 and d2: what a v that goes down borrows from u is not added to it
        move.l  d2,d6
        muls.l  inverse_u+inverse_dc(sp),d3:d6
        addq.l  #1,d3
        muls.l  inverse_v+inverse_dc(sp),d6:d2
        add.l   inverse_up_v(sp),d6
        beq     .level
.steps  moveq   #0,d2
        move.b  d6,d2
        ror.l   #8,d2                   ; v---
        movea.l d2,a2
        lsr.l   #8,d6                   ; .Vv
        swap    d3                      ; uuUU
        move.b  d3,d2                   ; v--U
        move.w  d6,d3                   ; uuVv

        movea.l a6,a1
        rounds  \1
        add.l   a2,d1
        ifc     '\1','right'
        lea     .pixels(pc,d6.w*4),a2
        else
        lea     .pixels(pc,d6.w*2),a2
        lea     (a2,d6.w*4),a2
        endc
        jmp     (a2,d6.w*8)
        cnop    0,4
.pixels rept    1<<ROUND_\1
        texel_next d3,d2
        ifc     '\1','right'
        draw
        else
        draw_down
        endc
        endr
        dbra    d7,.pixels
        endm

; The pixels of a column whose u does not change: v alone, in a chain of one register as span_affine_column's.
line_v  macro
        swap    d0                      ; ---U
        lsl.l   #8,d3
        swap    d3                      ; v-Vv
        muls.l  inverse_v+inverse_dc(sp),d6:d2
        add.l   inverse_up_v(sp),d6
        bmi     .falls
        lsl.l   #8,d6
        swap    d6                      ; v-Vv
.alone  ahead   d6,d2,a2,w              ; v-00
        move.l  d6,d2
        movea.l a6,a1
        rounds  down
        add.l   a2,d3
        lea     .column(pc,d6.w*4),a2
        jmp     (a2,d6.w*8)
        cnop    0,4
.column rept    1<<ROUND_down
        move.w  d3,d4                   ; mmVv
        move.b  d0,d4                   ; mmVU
        addx.l  d2,d3
        draw_down
        endr
        dbra    d7,.column
        endm

; The pixels of a line whose v does not change: u alone, in a chain of one register as span_affine_row's.
line_u  macro
        lsr.l   #8,d3
        move.w  d3,d4                   ; mmVv
        swap    d0                      ; uuUU
        muls.l  inverse_u+inverse_dc(sp),d6:d2
        addq.l  #1,d6
        swap    d6
        ext.w   d6                      ; uu-U
        bmi     .falls
        and.w   #$00ff,d0               ; uu-U, and the spare byte
.alone  ahead   d6,d2,a2,b              ; uu-0
        move.l  d6,d2
        movea.l a6,a1
        rounds  right
        add.l   a2,d0
        jmp     .row(pc,d6.w*8)
        cnop    0,4
.row    rept    1<<ROUND_right
        pixel_row
        endr
        dbra    d7,.row
        endm

; Draws the texel at d4 and goes on to the pixel below. 6 bytes.
draw_down macro
        movea.l d4,a2
        move.b  (a2),(a1)
        adda.l  a3,a1
        endm

; Draws the plan a0.
level_lines_draw macro
        movea.l a0,a6
        lea     -draw_sizeof(sp),sp
        movea.l sp,a4
        jsr     inverse_begin
        tst.l   d0
        beq     .done
        move.l  d1,draw_end(sp)
        move.l  a2,draw_cut(sp)
        ifc     '\1','down'
        movem.l perspective_plan_s+screen_plane_dx(a6),d0-d1
        or.l    d1,d0
        bne.s   .both
        cmpi.l  #PERSPECTIVE_STILL_HEIGHT+1,perspective_plan_width(a6)
        else
        move.l  inverse_up_v(sp),d0
        bne.s   .both
        cmpi.l  #PERSPECTIVE_STILL_WIDTH+1,perspective_plan_width(a6)
        endc
        scc     d0
.both   move.l  d0,draw_still(sp)
        movem.l inverse_q(sp),d5-d6
        move.l  perspective_plan_map(a6),d4     ; mm00
        movea.l d2,a4
        move.l  a5,d1                   ; x
        movea.l d3,a5
        movea.l perspective_plan_pitch(a6),a3
        movea.l perspective_plan_row(a6),a6
        move.l  (a0)+,d0                ; start0:left
        move.w  (a0)+,d6                ; last
        move.l  d6,d7
        move.l  a3,draw_pitch(sp)
        lea     1(a3),a1
        move.l  a1,draw_more(sp)
        ifc     '\1','right'
        adda.l  d1,a6
        suba.l  a3,a6
        move.l  a3,draw_step(sp)
        movea.l inverse_u+inverse_k(sp),a3
        else
        move.l  a3,d2
        muls.l  d1,d2
        adda.l  d2,a6
        subq.l  #1,a6
        moveq   #1,d2
        move.l  d2,draw_step(sp)
        endc
        tst.l   draw_still(sp)
        ifc     '\1','right'
        beq     .firstu
        lines_loop right,uv
        lines_loop right,u
.falls  or.w    #$ff00,d0               ; the spare byte
        borrow  d6,1<<16,w
        bra     .alone
        else
        beq     .firstv
        lines_loop down,uv
        lines_loop down,v
.falls  lsl.l   #8,d6
        swap    d6                      ; v-Vv
        or.l    #$ff0000,d6             ; the spare byte, and that of the start
        or.l    #$ff0000,d3
        borrow  d6,1<<24,l
        bra     .alone
        endc

.level  add.l   inverse_up(sp),d3       ; v does not go down after all
        subq.l  #1,d3
        bra     .steps

.done   lea     draw_sizeof(sp),sp
        return_all

        ; the steps to lines at a vertex, one less than d1 pixels away from where the line would be
.turned addq.w  #1,d1
        ext.l   d1
        lea     4(sp),a2
        add.l   inverse_whole(a2),d1
        move.l  d1,inverse_whole(a2)
        turn_c  u,a4
        turn_c  v,a5
        ifc     '\1','right'
        add.l   draw_pitch(a2),d1
        move.l  d1,draw_step(a2)
        adda.l  d1,a6
        addq.l  #1,d1
        move.l  d1,draw_more(a2)
        else
        move.l  a3,d2
        muls.l  d1,d2
        addq.l  #1,d2
        move.l  d2,draw_step(a2)
        adda.l  d2,a6
        add.l   a3,d2
        move.l  d2,draw_more(a2)
        endc
        rts
        endm
