        include "far.i"

; span_far_right - draws lines with perspective from their far, left ends on
;
; in:      a0  far_span*  the lines, the map, the table, K and C
; trashes: d0-d7/a0-a6
; reads:   the span, its lines, the table, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.24, both wrap at 256; 8-bit texels and pixels. A piece's steps are C times the
;          growth of r in it; a line's last piece is the beginning of a whole one
; error:   of u a unit of 2^-16 a pixel, and as much again where v wraps or falls; of v none; errors of C
;          and r: see far.h
; cost:    bench row persp_far_16
        span span_far_right
        far_lines right,0
