        include "upright.i"

; span_affine_upright - span_affine_scanline for columns of the frame
;
; in:      a0  span_plan*  the table, the frame, the map, a table of steps
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), their
;          steps, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels; pitch: bytes from a line's pixel to its
;          next; the next line is a byte further
; error:   none: u, v are stepped with all their bits
        span span_affine_upright
        upright_open
        upright_line
        move.l  (a2)+,d5
        move.l  (a2),d2
        apart_steps
        apart_start
        span_rounds_out 3
        span_enter_out 8
.pixels rept    8
        texel_next_apart d2,d3
        draw_upright
        endr
        upright_close
