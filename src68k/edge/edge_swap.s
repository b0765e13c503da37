        include "edge.i"

; \3 = \2 and its fraction \1 as one 16.16 number
joined  macro
        move.l  \1(a5),\3
        move.w  \2+2(a5),\3
        swap    \3
        endm

; edge_swap - fills a scanline table by add and swap, for comparison
;
; like:    edge_plain
; formats: x with EDGE_BIAS, 0 to 32,768; start0 = uu, start1 = UU,
;          start2 = VVvv; of error and part the upper 16 bits
; error:   none: the same numbers as edge_plain
; cost:    bench row edge_swap; some 13 cycles of it because the table keeps u's halves
;          apart, for addx
        routine edge_swap,a0
        save_all
        movea.l a0,a6
        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_left(a6),a5
        move.l  edge_plan_lefts(a6),-(sp)

.left_edge
        edge_end
        joined  edge_part,edge_whole,d3
        move.w  edge_whole+2(a5),d7
        move.l  edge_du(a5),d4
        move.l  edge_dv(a5),d5
        movea.l edge_plan_dudx(a6),a1
        movea.l edge_plan_dvdx(a6),a2
        move.l  edge_u(a5),d1
        move.l  edge_v(a5),d2
        joined  edge_error,edge_x,d0
        move.w  edge_x+2(a5),d6

        ; d0 x  d1 u  d2 v  d3 slope  d4, d5 u, v: a line and its whole pixels
        ; d6 left  d7 whole pixels  a1, a2 u, v: a pixel
.left_line
        move.w  d1,(a0)+
        move.w  d6,(a0)+
        swap    d1
        addq.l  #2,a0
        move.w  d1,(a0)+
        swap    d1
        move.l  d2,(a0)+
        add.l   d4,d1
        add.l   d5,d2
        add.w   d7,d6                   ; left without the fraction's carry
        add.l   d3,d0
        swap    d0
        cmp.w   d0,d6
        beq.s   .no_carry
        move.w  d0,d6
        add.l   a1,d1
        add.l   a2,d2
.no_carry
        swap    d0
        cmpa.l  a4,a0
        bne.s   .left_line
        lea     edge_sizeof(a5),a5
        subq.l  #1,(sp)
        bne.s   .left_edge
        addq.l  #4,sp

        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_right(a6),a5
        move.l  edge_plan_rights(a6),d4
        moveq   #scanline_sizeof,d5
.right_edge
        move.l  edge_lines(a5),d6
        subq.l  #1,d6
        joined  edge_part,edge_whole,d2
        joined  edge_error,edge_x,d0
.right_line
        move.l  d0,d1
        swap    d1
        subq.w  #1,d1
        move.w  d1,scanline_last(a0)
        adda.l  d5,a0
        add.l   d2,d0
        dbra    d6,.right_line
        lea     edge_sizeof(a5),a5
        subq.l  #1,d4
        bne.s   .right_edge
        return_all
