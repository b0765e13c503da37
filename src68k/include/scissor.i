        ifnd    SCISSOR_I
SCISSOR_I equ   1

        include "routine.i"

; Cuts the lines of a table to the frame's columns. \1: the macro that moves the start of
; the line d3 pixels to the right; a4 is the entry, a2 dudx, a3 dvdx, d0-d2/d4-d5 free.
scissor macro
        save_all
        movea.l scissor_plan_lines(a0),a4
        move.l  scissor_plan_count(a0),d7
        movea.l scissor_plan_dudx(a0),a2
        movea.l scissor_plan_dvdx(a0),a3
        move.w  scissor_plan_width+2(a0),d6
        add.w   #EDGE_BIAS-1,d6
        subq.l  #1,d7
.line   move.l  scanline_left(a4),d0    ; and last
        move.l  d0,d3
        swap    d3
        cmp.w   d3,d6
        blo.s   .outside
        addq.w  #1,d0                   ; unsigned: last may be -1, or 32,768
        cmp.w   d6,d0
        bhi.s   .right
.left   sub.w   #EDGE_BIAS,d3
        blo.s   .before
.next   lea     scanline_sizeof(a4),a4
        dbra    d7,.line
        return_all
.right  move.w  d6,scanline_last(a4)
        bra.s   .left
.before neg.w   d3                      ; pixels beyond the left border
        move.w  #EDGE_BIAS,scanline_left(a4)
        ext.l   d3
        \1
        bra.s   .next
.outside
        move.l  #EDGE_BIAS<<16+EDGE_BIAS-1,scanline_left(a4)    ; and last
        bra.s   .next
        endm

        endc
