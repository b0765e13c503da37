        include "edge.i"

        xref    edge_right,edge_right_exact

; Splits the 16.16 number \1 into its integer (\1's lower word) and \2 = uu--.
fraction macro
        move.l  \1,\2
        swap    \2
        swap    \1
        clr.w   \2
        endm

plain_steps macro
        move.l  d5,d4
        move.l  d7,d6
        move.l  d0,d5
        move.l  d2,d7
        fraction d5,d0
        add_below d0,d1,d5,w
        movea.l d0,a2
        fraction d7,d0
        addq.l  #1,d1
        add_below d0,d1,d7,w
        movea.l d0,a3
        endm

plain_start macro
        move.l  d3,d2                   ; VVvv
        move.l  d1,d3
        fraction d3,d1                  ; uu--, UU
        endm

; \1 uu:whole pixels, \2 UU, \3 VVvv
plain_step macro
        add.l   \1,d1
        addx.w  \2,d3
        add.l   \3,d2
        endm

; edge_plain - fills a scanline table: left, last and u, v in 16.16
;
; like:    edge_addx
; formats: x with EDGE_BIAS, 0 to 32,768; start0 = uu, start1 = UU,
;          start2 = VVvv
        routine edge_plain,a0
        edge_entry lines_plain

; lines_plain - the same for assembly
;
; like:    edge_plain
; trashes: d0-d7/a0-a6
; cost:    about 80 cycles less than edge_plain
        routine lines_plain
        edge_left plain,error_rounded,edge_right

; edge_plain_exact - the same, x by integer quotient and remainder
;
; like:    edge_plain
; reads:   the plan, its edges
; error:   none, and x is the rational one on every line
        routine edge_plain_exact,a0
        edge_entry lines_plain_exact

; lines_plain_exact - the same for assembly
;
; like:    edge_plain_exact
; trashes: d0-d7/a0-a6
; cost:    about 80 cycles less than edge_plain_exact
        routine lines_plain_exact
        edge_left plain,error_exact,edge_right_exact
