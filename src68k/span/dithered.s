        include "dither.i"

; span_dithered - span_affine_addx with u and v dithered in a pattern of 2x2 pixels
;
; like:    span_affine_addx
; in:      a0  span_plan*  the table, the frame, the map, the steps, odd
; formats: u, v 8.16, u wraps at 256, the moved v does not wrap inside a span; 8-bit texels
;          and pixels. With y the plan's odd plus the line's number, u is moved by
;          (4 (x & 1) - 2 (y & 1) - 1) / 8, v by (2 (x & 1) + 4 (y & 1) - 3) / 8 texel
; error:   none: pixel n shows texel (floor(u + n dudx + move), floor(v + n dvdx + move))

; The four points are the corners of a square, turned so that they divide each axis of a texel
; evenly. Their mean over 2x2 pixels approximates that of the bilinear filter, which is over all
; points within half a texel. Two steps by turns, in the chain of span_affine_addx.

        span span_dithered
        dither_chain_open
        lea     .pixels(pc),a3
        dither_chain_lines draw,,,a3
