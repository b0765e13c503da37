        include "perspective_pieces.i"

; span_perspective_pieces_32 - span_perspective_pieces with 32-bit texels and pixels
;
; like:    span_perspective_pieces
; formats: as span_perspective_pieces, with 32-bit texels and pixels; the map is a MAP_PAGE of such texels, at any
;          multiple of 4; plan->row is 4 EDGE_BIAS bytes before its first pixel
; cost:    as span_perspective_pieces_16
        routine span_perspective_pieces_32,a0
        perspective_lines_by_pieces 4
