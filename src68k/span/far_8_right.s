        include "far.i"

; span_far_8_right - the same, pieces of 8 pixels, from the far, left ends on
;
; like:    span_far_16_right
; cost:    as persp_far_8
        span span_far_8_right
        far_pieces 3,right,0
