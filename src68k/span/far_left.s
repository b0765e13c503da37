        include "far.i"

; span_far_left - the same from the right, where lines are far away
;
; like:    span_far_right
; cost:    as persp_far_16
        span span_far_left
        far_lines left,0
