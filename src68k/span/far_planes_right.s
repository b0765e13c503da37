        include "far_planes.i"

; span_far_planes_right - as span_far_right, with planes of u and v instead of constants
;
; in:      a0  far_planes_span*  the lines, the frame, the map, the table, the planes
; trashes: d0-d7/a0-a6
; reads:   the span, left and last of its lines, the table, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.24, both wrap at 256; 8-bit texels and pixels. Pieces are chords between products with
;          r; a line's last piece is the beginning of a whole one
; error:   of u a unit of 2^-16 a pixel of a piece, and as much again where v wraps or falls; of v
;          none; errors of the planes and r: see far.h
; cost:    bench row persp_planes_16
        span span_far_planes_right
        by_lines right
