        include "level_draw.i"

; level_draw_upright - level_draw for columns of the frame
;
; like:    level_draw
; formats: level_reciprocal's and span_affine_upright's. Where s is the same all down the columns, as on upright walls
;          with upright texels, u has no step: it is that of a column's first pixel, and v has no part in it
; cost:    about 385 cycles a column before the second pixel, 335 if u has no step

        routine level_draw_upright,a0
        save_all
        level_lines_draw down
