        include "wide.i"

; span_affine_32_scanline - span_affine_32_wrap with separate steps for each line
;
; like:    span_affine_32_wrap
; in:      a0  span_plan*  the table, the frame, the map, a table of steps
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), their
;          steps, the map

        span span_affine_32_scanline
        wide_scanline 4
