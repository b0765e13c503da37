        include "perspective_pieces.i"

; span_perspective_pieces_16 - span_perspective_pieces with 16-bit texels and pixels
;
; like:    span_perspective_pieces
; formats: as span_perspective_pieces, with 16-bit texels and pixels; the map is a MAP_PAGE of such texels, at any
;          multiple of 2; plan->row is 2 EDGE_BIAS bytes before its first pixel
; cost:    bench row persp_every16_wide
        routine span_perspective_pieces_16,a0
        perspective_lines_by_pieces 2
