        include "far_planes.i"

; span_far_planes_left - the same from the right
;
; like:    span_far_planes_right
; cost:    as persp_planes_16
        span span_far_planes_left
        by_lines left
