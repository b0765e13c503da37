        include "span.i"

; span_affine_scanline - span_affine_addx_wrap with separate steps for each line
;
; like:    span_affine_addx_wrap
; in:      a0  span_plan*  the table, the frame, the map, a table of steps
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), their
;          steps, the map

        span span_affine_scanline
        level_open d4
        lea     .pixels_end-14(pc),a3
        span_line d0,d1
        movea.l (sp),a2
        move.l  (a2)+,d5
        move.l  (a2),d2
        apart_steps
        apart_start
        span_rounds 3
        span_enter 2,4
.pixels rept    8
        pixel_apart
        endr
.pixels_end
        level_next
