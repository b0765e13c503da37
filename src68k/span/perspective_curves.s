        include "perspective_curves.i"

; span_perspective_curves - draws lines with perspective, by curved pieces
;
; like:    span_perspective_pieces
; in:      a0  perspective_span*  the lines, the frame, the map, the longest piece
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels. A piece of 4, 8, 16 or
;          32 pixels is a parabola through its exact first and middle pixel and the one
;          after it. It draws the longest piece whose least weight is enough, else a single
;          pixel. The last piece ends with the line and overlaps the piece before it
; error:   of a point 3 units, of a second difference half a unit, which adds the square of
;          half the piece's length in half units; the parabola's: see perspective_lines
; cost:    bench rows persp_pixel_exact, persp_pixel_fine

        routine span_perspective_curves,a0
        perspective_lines_by_curves 1
