        include "far.i"

; span_far_right_coarser - the same with constants that are still farther away
;
; like:    span_far_right
; cost:    as persp_far_16; where a line begins, products of 32 bits
        span span_far_right_coarser
        far_lines right,8
