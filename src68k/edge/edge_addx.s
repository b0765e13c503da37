        include "edge.i"

        xref    edge_right,edge_right_exact

addx_steps macro
        pack_uv d0,d5,d4
        add_below d0,d1,d4,b
        movea.l d0,a2
        pack_uv d2,d7,d6
        addq.l  #1,d1
        add_below d2,d1,d6,b
        movea.l d2,a3
        endm

addx_start macro
        pack_uv d1,d3,d2                ; uu--, ..Vv, v--U
        endm

; \1 uu:whole pixels, \2 Vv, \3 v--U
addx_step macro
        add.l   \1,d1
        addx.l  \3,d2
        addx.w  \2,d3
        endm

; edge_addx - fills a scanline table: left, last and packed u, v
;
; in:      a0  edge_plan*  both sides, their edges, the pixel steps
; reads:   the plan, its edges except height
; writes:  plan->lines[0 .. lines of one side - 1]
; formats: x with EDGE_BIAS, 0 to 32,768; start0 = uu, start1 = Vv,
;          start2 = v--U
; error:   none: u = u0 + n du + (pixels beyond n whole) dudx modulo 2^32
        routine edge_addx,a0
        edge_entry lines_addx

; lines_addx - the same for assembly
;
; like:    edge_addx
; trashes: d0-d7/a0-a6
; cost:    about 80 cycles less than edge_addx
        routine lines_addx
        edge_left addx,error_rounded,edge_right

; edge_addx_exact - the same, x by integer quotient and remainder
;
; like:    edge_addx
; reads:   the plan, its edges
; error:   none, and x is the rational one on every line
        routine edge_addx_exact,a0
        edge_entry lines_addx_exact

; lines_addx_exact - the same for assembly
;
; like:    edge_addx_exact
; trashes: d0-d7/a0-a6
; cost:    about 80 cycles less than edge_addx_exact
        routine lines_addx_exact
        edge_left addx,error_exact,edge_right_exact
