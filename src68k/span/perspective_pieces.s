        include "perspective_pieces.i"

; span_perspective_pieces - draws lines with perspective, by linear pieces
;
; in:      a0  perspective_span*  the lines, the frame, the map, log2 of a piece: 3 to 6
; reads:   the plan, its lines, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels. u and v are right at the
;          first pixel of each piece, rounded down to a multiple of as many units as it has
;          pixels, so that the steps are whole; the last piece ends with the line
; error:   at the ends of pieces two units more than a piece has pixels; at the last pixel as
;          many units as the last piece has steps
; cost:    bench rows persp_every16_exact, persp_every8_exact
        routine span_perspective_pieces,a0
        perspective_lines_by_pieces 1
