        include "routine.i"
        include "layout.i"
        include "edge.i"

; \1: what steps x.
steps   macro
        movea.l edge_plan_lines(a6),a0
        movea.l edge_plan_right(a6),a5
        move.l  edge_plan_rights(a6),d5
        edge_loop write_count,\1
        rts
        endm

write_count macro
        move.w  d1,d2
        sub.w   scanline_left(a0),d2
        move.w  d2,scanline_count(a0)
        endm

;==============================================================================
; edge_right - steps the right side and writes the counts; left must be there
;
; in:      a6  edge_plan*  the right side and its edges
; out:     -
; trashes: d0-d7/a0-a1/a4-a5
; reads:   the plan, its right edges but for height, left of plan->lines
; writes:  count of plan->lines[0 .. lines of the side - 1]
; formats: x with EDGE_BIAS, 0 < x < 32,768; count = x - left
; error:   none
; cost:    part of edge_addx, edge_plain and edge_flat, which call it
;==============================================================================
        routine edge_right
        steps   edge_step

;==============================================================================
; edge_right_exact - the same, x by integer quotient and remainder
;
; in:      a6  edge_plan*  the right side and its edges
; out:     -
; trashes: d0-d7/a0-a1/a4-a5
; reads:   the plan, its right edges, left of plan->lines
; writes:  count of plan->lines[0 .. lines of the side - 1]
; formats: as edge_right
; error:   none, and x is the rational one on every line
; cost:    part of edge_addx_exact and so on, which call it
;==============================================================================
        routine edge_right_exact
        steps   edge_step_exact
