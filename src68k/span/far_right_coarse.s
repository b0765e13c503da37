        include "far.i"

; span_far_right_coarse - the same with constants that are far away
;
; like:    span_far_right
; cost:    as persp_far_16, and 60 cycles where a line begins, 10 a piece
        span span_far_right_coarse
        far_lines right,4
