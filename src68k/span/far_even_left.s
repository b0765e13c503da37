        include "far_even.i"

; span_far_even_left - the same from the right, where lines are far away
;
; like:    span_far_even_right
; cost:    as persp_even_16
        span span_far_even_left
        even_lines left,0
