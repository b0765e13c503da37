; Parts shared by the scanline steppers. A side's x is whole pixels and an error that
; counts up to 2^32: a carry moves x one pixel to the right (see struct edge).

        include "chain.i"

; a4 = end of the table's part that the edge in a5 covers; 12 bytes an entry. Uses d0.
edge_end macro
        move.l  edge_lines(a5),d0
        lsl.l   #2,d0
        lea     (a0,d0.l*2),a4
        adda.l  d0,a4
        endm

; Writes x of the d5 edges from a5 on to the table: at a0, and on by an entry a line.
; \1: the macro that steps x (d1) and its error (d0) by a line; a1 the error's part,
; d4 whole pixels, d7 height. \2: added to x. Two lines a round; an odd number begins
; with one. Uses d3/d6/a4.
edge_loop macro
        movea.w #2*scanline_sizeof,a4
.edge   moveq   #\2,d1
        add.w   edge_x+2(a5),d1
        move.l  edge_whole(a5),d4
        move.l  edge_error(a5),d0
        movea.l edge_part(a5),a1
        move.l  edge_height(a5),d7
        move.l  edge_lines(a5),d6
        lsr.w   #1,d6
        bcs.s   .odd
        subq.w  #1,d6
.lines  move.w  d1,(a0)
        \1
.line   move.w  d1,scanline_sizeof(a0)
        adda.l  a4,a0
        \1
        dbra    d6,.lines
        lea     edge_sizeof(a5),a5
        subq.l  #1,d5
        bne.s   .edge
        bra.s   .stepped
.odd    lea     -scanline_sizeof(a0),a0
        bra.s   .line
.stepped
        endm

edge_step macro
        add.l   a1,d0
        addx.w  d4,d1
        endm

edge_step_exact macro
        add.l   a1,d0
        subx.l  d3,d3                   ; -1 after a carry; X stays
        addx.w  d4,d1
        and.l   d7,d3
        sub.l   d3,d0
        endm

; Corrects the error d0 after a carry: an exact one counts the height a6 up to 2^32, so
; the height is subtracted.
error_rounded macro
        endm

error_exact macro
        sub.l   a6,d0
        endm

; Writes a line's entry and steps x's error: carry is set if x moves one pixel more.
left_line macro
        move.l  d1,(a0)+                ; start0:left
        move.l  d3,(a0)+                ; --:start1, where last comes later
        move.l  d2,(a0)+                ; start2
        add.l   a1,d0
        endm

; Fills the left side of a table whose lines begin with u and v. \1: the form, which is
; the prefix of three macros of its file. \1_steps packs the step of a line with d1
; whole pixels, du (d0) and dv (d5), into a2 d5 d4, and that with one pixel more, du (d2)
; and dv (d7), into a3 d7 d6. \1_start packs u (d1) and v (d3) into d1 (upper word), d3,
; d2; \1_step adds a packed step to them. \2: error_rounded or error_exact; \3: the
; routine for the right side.
; u and v are those of the line's first pixel: their step is a line down and as many
; pixels to the right as x moves, one more after a carry. So they stay on the plane
; without a multiplication a line.
edge_left macro
        move.l  a0,-(sp)
        move.l  edge_plan_lefts(a0),-(sp)
        movea.l edge_plan_left(a0),a5
        movea.l edge_plan_lines(a0),a0

.left_edge
        edge_end
        movea.l 4(sp),a1
        move.l  edge_whole(a5),d1
        move.l  edge_du(a5),d0
        move.l  edge_dv(a5),d5
        move.l  edge_plan_dudx(a1),d2
        add.l   d0,d2
        move.l  edge_plan_dvdx(a1),d7
        add.l   d5,d7
        \1_steps
        move.l  edge_u(a5),d1
        move.l  edge_v(a5),d3
        \1_start
        move.w  edge_x+2(a5),d1         ; start0:left
        move.l  edge_error(a5),d0
        movea.l edge_part(a5),a1
        movea.l edge_height(a5),a6

        ; d0 error  a1 its part a line  a6 height  a0 entry  a4 end
        ; two lines a round; an odd number begins with one
        btst    #0,edge_lines+3(a5)
        bne.s   .second
.first  left_line
        bcs.s   .first_more
        \1_step a2,d5,d4
.second left_line
        bcs.s   .second_more
        \1_step a2,d5,d4
        cmpa.l  a4,a0
        bne.s   .first
        bra.s   .left_next
.first_more
        \2
        \1_step a3,d7,d6
        left_line
        bcs.s   .second_more
        \1_step a2,d5,d4
        cmpa.l  a4,a0
        bne.s   .first
        bra.s   .left_next
.second_more
        \2
        \1_step a3,d7,d6
        cmpa.l  a4,a0
        bne.s   .first
.left_next
        lea     edge_sizeof(a5),a5
        subq.l  #1,(sp)
        bne     .left_edge
        addq.l  #4,sp
        movea.l (sp)+,a6
        jmp     \3
        endm

; The entry of a stepper for C: keeps registers that \1 changes.
edge_entry macro
        save_all
        jsr     \1
        return_all
        endm
