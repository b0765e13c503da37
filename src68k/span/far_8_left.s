        include "far.i"

; span_far_8_left - the same, pieces of 8 pixels, from the far, right ends on
;
; like:    span_far_16_right
; cost:    as persp_far_8
        span span_far_8_left
        far_pieces 3,left,0
