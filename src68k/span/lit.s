        include "span.i"

; span_lit - span_affine_addx through one row of a light table
;
; like:    span_affine_addx
; in:      a0  span_plan*  the table, the frame, the map, the row, the steps
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map,
;          256 bytes at light, a multiple of 256
; error:   none: pixel n shows light[texel (floor(u + n dudx), floor(v + n dvdx))]
; cost:    bench row affine_lit

        span span_lit
        chain_open light
        move.l  (sp),d5                 ; lll0
        lea     .pixels_end-16(pc),a3
        span_line d0,d1
        span_rounds 3
        add.l   a4,d1
        span_enter 8
.pixels rept    8
        texel_next d2,d3
        draw_lit d5
        endr
        span_close 4(sp),8
