        include "far.i"

; span_far_8_right_coarse - the same with constants that are far away
;
; like:    span_far_16_right
; cost:    as persp_far_8, and 20 cycles a piece
        span span_far_8_right_coarse
        far_pieces 3,right,4
