; Edges between two vertices.

        include "routine.i"

; For the edge a0 from the vertex a1 down to a2, whose first line is d1: d1 = from the upper end down to
; that line, d4 = width, d5 = height, d6 = lines, d7 = x of the upper end.
extent  macro
        swap    d1
        clr.w   d1
        sub.l   vertex_y(a1),d1
        move.l  vertex_y(a2),d5
        sub.l   vertex_y(a1),d5
        move.l  vertex_x(a1),d7
        move.l  vertex_x(a2),d4
        sub.l   d7,d4
        move.l  edge_lines(a0),d6
        endm
