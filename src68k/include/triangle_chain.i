; Triangles whose lines become a scanline table with u and v in the form of an addx chain, and, where
; LEVELS is 1, the plane of their levels of light.

        include "chain.i"
        include "triangle_table.i"

; The line at a1 begins with B and A, d0 and d1, at x = a3, whose error is d5, part a4 and whole a2; one
; right of its last x in a6, with d6 and a0. Steps of B and A: a line and whole pixels, d7 and a5; a
; pixel more, d2 and d3. d4.b is 0.
;
; They are sums of the steps L a line along the long edge and P a pixel to the right. With the long edge
; on the right, of D = L - whole P, which is straight down, and P.

; On the stack, once the first short edge is in registers. Right only:
down_b          equ     wide_r_error
down_a          equ     wide_r
pixel_u         equ     wide_r_part
pixel_v         equ     wide_r_step

; B:A \1:\2 are added to d0:d1; d4.b is 0. \1 is a data register.
chain_add macro
        add.l   \2,d1
        addx.l  \1,d0
        addx.b  d4,d1
        endm

; d0:d1 = B:A of d5 steps of d2 (u) and d3 (v): 48 bits of the exact product. Uses d4/a4.
chain_times macro
        move.l  d2,d0
        muls.l  d5,d0
        move.l  d3,d1
        muls.l  d5,d4:d1
        movea.l d1,a4
        rol.l   #8,d1
        lsl.l   #8,d4
        move.b  d1,d4                   ; wraps of v
        add.l   d4,d0
        move.l  a4,d1
        pack_pair d0,d1,d4
        moveq   #0,d4
        endm

; v's step a pixel, -128 to 128 texels: spans take it modulo 256.
modulo  macro
        lsl.l   #8,\1
        asr.l   #8,\1
        endm

; The right side's next line; its whole at \1.
right_side macro
        adda.l  \1,a6
        add.l   a0,d6
        bcc.s   .right\@
        addq.l  #1,a6
.right\@
        endm

; The lines, down to the middle vertex and from there on; long edge on the side \1. \2: the right
; side's whole.
chain_lines macro
.next_\1
        right_side \2
.left_\1
        add.l   a5,d1
        addx.l  d7,d0
        addx.b  d4,d1
        adda.l  a2,a3
        add.l   a4,d5
        bcc.s   .line_\1
        addq.l  #1,a3
        add.l   d3,d1
        addx.l  d2,d0
        addx.b  d4,d1
.line_\1
        swap    d0
        move.w  d0,(a1)+                ; uu
        move.w  a3,(a1)+                ; left
        move.w  a6,(a1)+                ; last
        swap    d0
        move.w  d0,(a1)+                ; Vv
        move.l  d1,(a1)+                ; v--U
        subq.l  #1,(sp)
        bne.s   .next_\1
        move.l  wide_count_2(sp),(sp)
        beq     table_end
        clr.l   wide_count_2(sp)
        endm

; Long edge on the left: the second short edge becomes the right side.
second_left macro
        move.l  wide_r_step_2(sp),wide_r_step(sp)
        movea.l wide_r_part_2(sp),a0
        movea.l wide_r_2(sp),a6
        subq.l  #1,a6
        move.l  wide_r_error_2(sp),d6
        bra.s   .left_left
        endm

; On the right: it becomes the left side, so B and A go straight down and some pixels along.
second_right macro
        right_side wide_l_step(sp)
        movea.l d0,a2
        movea.l d1,a5
        movem.l pixel_u(sp),d2-d3
        move.l  wide_r_2(sp),d5
        sub.l   a3,d5
        adda.l  d5,a3
        chain_times
        move.l  down_b(sp),d7
        chain_add d7,down_a(sp)
        move.l  a2,d7
        chain_add d7,a5
        movea.l d0,a2
        movea.l d1,a5
        move.l  wide_r_step_2(sp),d5
        chain_times
        move.l  down_b(sp),d7
        chain_add d7,down_a(sp)
        move.l  d0,d7
        exg     d1,a5
        move.l  a2,d0
        pack_step d2,d3,d4
        moveq   #0,d4
        movea.l wide_r_step_2(sp),a2
        movea.l wide_r_part_2(sp),a4
        move.l  wide_r_error_2(sp),d5
        bra     .line_right
        endm

table_wide macro
        ifne    LEVELS
        level_gradient
        endc
        texel_gradients SLIVER_WIDE,\1
        moveq   #15,d5
        long_wide \1
        ifne    LEVELS
        level_start \1
        endc
        value_start_wide snapped_vertex_u,a6,a4,a6
        move.l  d7,-(sp)
        value_start_wide snapped_vertex_v,a3,a2,a3
        table_begin 4
        table_\1
        move.l  wide_count_1(sp),(sp)
        moveq   #0,d4
        bra     .line_\1
        texel_slivers \1
        endm

; Long edge on the left. a6 and a3: u and v at the first pixel, a4 and a2: their steps a pixel, (sp)
; and d7: a line, a0 the first pixel.
table_left macro
        move.l  a4,span_plan_dudx(a5)
        move.l  a2,span_plan_dvdx(a5)
        move.l  a6,d0
        move.l  a3,d1
        pack_pair d0,d1,d4
        move.l  a4,d2
        move.l  a2,d3
        modulo  d3
        pack_step d2,d3,d4
        move.l  (sp)+,d6
        pack_step d6,d7,d4
        movea.l d7,a5
        move.l  d6,d7
        move.l  (sp),d5
        movea.l wide_l_part(sp),a4
        movea.l wide_l_step(sp),a2
        movea.l a0,a3
        movea.l wide_r_part(sp),a0
        movea.l wide_r(sp),a6
        subq.l  #1,a6
        move.l  wide_r_error(sp),d6
        endm

; On the right: steps a pixel are to the left.
table_right macro
        move.l  a4,d2
        neg.l   d2
        move.l  a2,d3
        neg.l   d3
        move.l  d2,span_plan_dudx(a5)
        move.l  d3,span_plan_dvdx(a5)
        modulo  d3
        move.l  (sp)+,d6
        pack_step d6,d7,d4              ; L
        move.l  wide_l_step(sp),d5
        neg.l   d5
        movea.l wide_r(sp),a2           ; the first line's left x
        chain_times
        chain_add d6,d7
        movea.l d0,a5                   ; D
        move.l  d1,d7
        move.l  a2,d5
        addq.l  #1,d5
        sub.l   a0,d5                   ; from the value's pixel
        chain_times
        exg     d0,a6
        move.l  d1,d6
        move.l  a3,d1
        pack_pair d0,d1,d4
        moveq   #0,d4
        exg     d6,a6
        chain_add d6,a6
        movea.l d0,a6
        movea.l d1,a3
        move.l  wide_r_step(sp),d5
        chain_times
        move.l  a5,d6
        chain_add d6,d7                 ; the step of the left edge's line
        exg     d0,a6
        exg     d1,a3
        ; d0:d1 start, a6:a3 line's step, a5:d7 D, d2, d3 P
        move.l  wide_r_error(sp),d5
        movea.l wide_r_part(sp),a4
        move.l  a5,down_b(sp)
        move.l  d7,down_a(sp)
        move.l  a6,d7
        movea.l a3,a5
        movea.l a2,a3
        movea.l wide_r_step(sp),a2
        movem.l d2-d3,pixel_u(sp)
        pack_step d2,d3,d4
        lea     -1(a0),a6
        movea.l wide_l_part(sp),a0
        move.l  (sp),d6
        endm

; A routine: its contract is before it.
chain_table macro
        table_open
        table_close
texel_quotient
        triangle_quotient
        table_set_up table
        chain_lines left,wide_r_step(sp)
        second_left
        chain_lines right,wide_l_step(sp)
        second_right
        endm
