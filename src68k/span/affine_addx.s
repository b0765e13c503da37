        include "span.i"

; span_affine_addx - draws a scanline table from a 256x256 map, the addx chain
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.16, both wrap at 256; 8-bit texels and pixels. If v wraps inside
;          a span, it may do so once, and the lowest bit of u must be free: dudx
;          even, u's own bit 0, or 1 if dvdx is negative
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v + n dvdx))

; One circular carry chain over two registers:
;       B  uuVv   u's fraction, V, the upper byte of v's fraction
;       A  v--U   the lower byte of v's fraction, two spare bytes, U
; addx B takes A's carry (v) and gives its own (u) to addx A. MOVE, LEA, JMP and
; DBRA keep X between pixels. A's v runs one step ahead, so that its carry is
; ready when B needs it. V's own overflow enters u's lowest bit: see formats.

        span span_affine_addx
        chain_open
        lea     .pixels_end-12(pc),a3
        span_line d0,d1
        span_rounds 4
        add.l   a4,d1
        span_enter 4
.pixels rept    16
        pixel_chain
        endr
        span_close d5,0
