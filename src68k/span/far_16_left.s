        include "far.i"

; span_far_16_left - the same, pieces of 16 pixels, from the far, right ends on
;
; like:    span_far_16_right
; cost:    as persp_far_16
        span span_far_16_left
        far_pieces 4,left,0
