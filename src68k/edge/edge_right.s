        include "edge.i"

; \1: the macro that steps x.
steps   macro
        movea.l edge_plan_lines(a6),a0
        addq.l  #scanline_last,a0
        movea.l edge_plan_right(a6),a5
        move.l  edge_plan_rights(a6),d5
        edge_loop \1,-1             ; the pixel before the edge
        rts
        endm

; edge_right - steps the right side: the last pixel of each line
;
; in:      a6  edge_plan*  the right side and its edges
; trashes: d0-d7/a0-a1/a4-a5
; reads:   the plan, its right edges except height
; writes:  last of plan->lines[0 .. lines of the side - 1]
; formats: x with EDGE_BIAS, 0 to 32,768; last = x - 1
; cost:    part of edge_addx, edge_plain and edge_flat, which call it
        routine edge_right
        steps   edge_step

; edge_right_exact - the same, x by integer quotient and remainder
;
; like:    edge_right
; reads:   the plan, its right edges
; error:   none, and x is the rational one on every line
; cost:    part of edge_addx_exact and so on, which call it
        routine edge_right_exact
        steps   edge_step_exact
