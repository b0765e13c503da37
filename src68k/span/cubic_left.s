        include "cubic.i"

; span_cubic_left - the same from the right, where lines are far away
;
; like:    span_cubic_right
; cost:    as persp_pixel
        span span_cubic_left
        cubic_lines left
