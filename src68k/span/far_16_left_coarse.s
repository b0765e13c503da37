        include "far.i"

; span_far_16_left_coarse - the same with constants that are far away
;
; like:    span_far_16_right
; cost:    as persp_far_16, and 20 cycles a piece
        span span_far_16_left_coarse
        far_pieces 4,left,4
