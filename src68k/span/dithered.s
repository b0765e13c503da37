        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"
        include "dither.i"

;==============================================================================
; span_dithered - span_affine_addx with points that are moved in a pattern of 2x2 pixels
;
; in:      a0  span_plan*  the table, the frame, the map, the steps, the moves
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.16, u wraps at 256, v, moved, does not inside a span; 8-bit texels and
;          pixels. With e the plan's eighth, a multiple of 1/8 texel, and y its odd plus
;          the line's number, u is moved by (4 (x & 1) - 2 (y & 1) - 1) e, v by
;          (2 (x & 1) + 4 (y & 1) - 3) e
; error:   none: pixel n shows texel (floor(u + n dudx + move), floor(v + n dvdx + move))
; cost:    bench row dithered
;==============================================================================
; The four points are the corners of a square, turned so that they part each axis of a texel
; evenly: their mean over 2x2 pixels stands in for the bilinear filter's, which is that over all
; points within half a texel. Two steps in turn, in the chain of span_affine_addx.

        routine span_dithered,a0
        dither_chain_open
        lea     .pixels(pc),a3
        dither_chain_lines draw,,,a3
