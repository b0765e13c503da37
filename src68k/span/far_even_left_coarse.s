        include "far_even.i"

; span_far_even_left_coarse - the same from the right, with constants that are far away
;
; like:    span_far_even_right
; cost:    as persp_even_16; where a line begins, products of 32 bits
        span span_far_even_left_coarse
        even_lines left,4
