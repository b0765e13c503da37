        include "edge.i"

        xref    edge_right,edge_right_exact

; \1: the macro that steps x; \2: the routine for the right side.
steps   macro
        movea.l a0,a6
        movea.l edge_plan_lines(a6),a0
        addq.l  #scanline_left,a0
        movea.l edge_plan_left(a6),a5
        move.l  edge_plan_lefts(a6),d5
        edge_loop \1,0
        jmp     \2
        endm

; edge_flat - fills a scanline table without u and v, for flat polygons
;
; in:      a0  edge_plan*  both sides and their edges
; reads:   the plan, of its edges lines, x, whole, error and part
; writes:  left and last of plan->lines[0 .. lines of one side - 1]
; formats: x with EDGE_BIAS, 0 to 32,768
        routine edge_flat,a0
        edge_entry lines_flat

; lines_flat - the same for assembly
;
; like:    edge_flat
; trashes: d0-d7/a0-a6
; cost:    about 80 cycles less than edge_flat
        routine lines_flat
        steps   edge_step,edge_right

; edge_flat_exact - the same, x by integer quotient and remainder
;
; like:    edge_flat
; reads:   the plan, of its edges lines, x, whole, error, part and height
; error:   none, and x is the rational one on every line
        routine edge_flat_exact,a0
        edge_entry lines_flat_exact

; lines_flat_exact - the same for assembly
;
; like:    edge_flat_exact
; trashes: d0-d7/a0-a6
; cost:    about 80 cycles less than edge_flat_exact
        routine lines_flat_exact
        steps   edge_step_exact,edge_right_exact
