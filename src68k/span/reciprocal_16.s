        include "reciprocal.i"

; span_reciprocal_16 - draws lines with perspective, pieces of 16 pixels, by a table
;
; in:      a0  reciprocal_span*  the lines, the frame, the map, the table
; reads:   the span, its lines, the table, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.24, both wrap at 256; 8-bit texels and pixels. A piece's steps are C
;          times the growth of r in it; the last piece ends with the line's r
; error:   of u half a unit of 2^-16 a pixel and one if v wraps, of v none; errors of
;          C and r: see reciprocal_lines
; cost:    bench row persp_every16
        routine span_reciprocal_16,a0
        reciprocal_pieces 4
