        include "far.i"

; span_far_left_coarser - the same from the right, with constants that are still farther away
;
; like:    span_far_right
; cost:    as persp_far_16; where a line begins, products of 32 bits
        span span_far_left_coarser
        far_lines left,8
