        include "far_even.i"

; span_far_even_left_coarser - the same from the right, with constants that are still farther away
;
; like:    span_far_even_right
; cost:    as persp_even_16; where a line begins, products of 32 bits
        span span_far_even_left_coarser
        even_lines left,8
