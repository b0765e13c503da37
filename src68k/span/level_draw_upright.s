        include "level_draw.i"

; level_draw_upright - level_draw for columns of the frame
;
; like:    level_draw
; formats: level_reciprocal's and span_affine_upright's
; cost:    as level_draw

        routine level_draw_upright,a0
        save_all
        level_lines_draw down
