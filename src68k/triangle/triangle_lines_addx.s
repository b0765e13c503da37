LEVELS          equ     0

        include "triangle_chain.i"

; triangle_lines_addx - the scanline table of a batch's next triangle, for spans with an addx chain
;
; like:    triangle_lines_flat
; reads:   the plan, its list, the vertices' x, y, u, v, the reciprocals
; writes:  of the span: lines, count; row, dudx and dvdx if there are lines
; formats: vertices in 12.4, u and v in 12.20; dudx, dvdx 16.16; start0 = uu, start1 = Vv,
;          start2 = v--U
; error:   coverage: none for the snapped vertices. u and v: as triangles_affine, with the same sums
; cost:    bench rows triangle_lines_addx
        routine triangle_lines_addx,a0
        chain_table
