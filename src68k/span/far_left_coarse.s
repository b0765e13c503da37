        include "far.i"

; span_far_left_coarse - the same from the right with constants that are far away
;
; like:    span_far_right
; cost:    as persp_far_16; where a line begins, products of 32 bits
        span span_far_left_coarse
        far_lines left,4
