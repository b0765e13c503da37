        include "routine.i"
        include "layout.i"
        include "edge.i"

        xref    edge_right
        xref    edge_right_exact

; As in edge_addx, with u and v in 16.16. \1: what corrects the error d0 after a
; carry; \2: what steps the right side.
steps   macro
        movem.l d2-d7/a2-a6,-(sp)
        move.l  a0,-(sp)
        move.l  edge_plan_lefts(a0),-(sp)
        movea.l edge_plan_left(a0),a5
        movea.l edge_plan_lines(a0),a0

.left_edge
        edge_end
        movea.l 4(sp),a1
        move.l  edge_whole(a5),d1
        move.l  edge_du(a5),d5
        move.l  d5,d7
        add.l   edge_plan_dudx(a1),d7
        move.l  edge_dv(a5),d4
        move.l  d4,d6
        add.l   edge_plan_dvdx(a1),d6
        fraction d5,d0                  ; uu--, d5 UU
        whole_pixels d0,d1,d5,w
        movea.l d0,a2                   ; a line
        fraction d7,d0
        addq.l  #1,d1
        whole_pixels d0,d1,d7,w
        movea.l d0,a3                   ; a line and a pixel
        move.l  edge_u(a5),d3
        fraction d3,d1
        move.l  edge_v(a5),d2
        move.w  edge_x+2(a5),d1         ; uu:left
        move.l  edge_error(a5),d0
        movea.l edge_part(a5),a1
        movea.l edge_height(a5),a6

        ; d0 error  a1 its part a line  a6 height
        ; d1 uu:left  d3 UU  d2 VVvv; steps: a2 d5 d4, after a carry a3 d7 d6
.left_line
        move.l  d1,(a0)+                ; uu:left
        move.l  d3,(a0)+                ; --:UU, where the count comes later
        move.l  d2,(a0)+                ; VVvv
        add.l   a1,d0
        bcs.s   .pixel_more
        add.l   a2,d1
        addx.w  d5,d3
        add.l   d4,d2
        cmpa.l  a4,a0
        bne.s   .left_line
        bra.s   .left_next
.pixel_more
        \1
        add.l   a3,d1
        addx.w  d7,d3
        add.l   d6,d2
        cmpa.l  a4,a0
        bne.s   .left_line
.left_next
        lea     edge_sizeof(a5),a5
        subq.l  #1,(sp)
        bne     .left_edge
        addq.l  #4,sp
        movea.l (sp)+,a6
        jsr     \2
        movem.l (sp)+,d2-d7/a2-a6
        rts
        endm

; Parts the 16.16 number \1 into its integer (\1's lower word) and \2 = uu--.
fraction macro
        move.l  \1,\2
        swap    \2
        swap    \1
        clr.w   \2
        endm

;==============================================================================
; edge_plain - fills a scanline table: left, count and u, v in 16.16
;
; in:      a0  edge_plan*  both sides, their edges, the pixel steps
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its edges but for height
; writes:  plan->lines[0 .. lines of one side - 1]
; formats: x with EDGE_BIAS, 0 < x < 32,768; start0 = uu, start1 = UU,
;          start2 = VVvv
; error:   none: u = u0 + n du + (pixels beyond n whole) dudx modulo 2^32
; cost:    bench row edge_plain
;==============================================================================
        routine edge_plain,a0
        steps   error_rounded,edge_right

;==============================================================================
; edge_plain_exact - the same, x by integer quotient and remainder
;
; in:      a0  edge_plan*  both sides, their edges, the pixel steps
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its edges
; writes:  plan->lines[0 .. lines of one side - 1]
; formats: as edge_plain
; error:   none, and x is the rational one on every line
; cost:    bench row edge_plain_exact
;==============================================================================
        routine edge_plain_exact,a0
        steps   error_exact,edge_right_exact
