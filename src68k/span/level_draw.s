        include "level_draw.i"

; level_draw - draws lines of one depth each, by one reciprocal a line
;
; in:      a0  perspective_plan*  as level_reciprocal's; row, pitch and map; it is chained
; out:     d0  int32              1; 0 if the numbers do not fit: nothing is drawn
; reads:   the plan, left and last of its lines, the map
; writes:  the pixels of the lines, nothing else
; formats: level_reciprocal's and span_affine_level's; 8-bit texels and pixels. Lines of the table begin less than
;          32,768 pixels apart. Where t is the same all along the lines, u alone is stepped
; error:   theirs
; cost:    about 400 cycles a line before the second pixel, 350 if v has no step

        routine level_draw,a0
        save_all
        level_lines_draw right
