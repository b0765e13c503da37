        include "cubic.i"

; span_cubic_right - draws lines with perspective from their far, left ends on, by cubics
;
; in:      a0  cubic_span*  the lines, the map, K, C and the lengths of pieces
; trashes: d0-d7/a0-a6
; reads:   the span, its lines, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.24, both wrap at 256; 8-bit texels and pixels. q 1.31, r and C 32 bits. A piece has the pixels for
;          which q grows by less than lambda times q, 1 to the longest
; error:   of a piece's first pixel a unit and those of q and C; of the others the cubic's, see tmap.base.cubics, and
;          what cuts of the terms add, see span/cubic.h
; cost:    bench row persp_pixel
        span span_cubic_right
        cubic_lines right
