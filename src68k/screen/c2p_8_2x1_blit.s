        include "planar.i"

; c2p_8_2x1_blit - a chunky frame as four half planes, which the blitter doubles
;
; in:      a0  const planar_plan*  the pixels and the half planes; a width that is a multiple of 16 will do
; writes:  the rows of four half planes
; formats: 8-bit chunky pixels; half plane b21 has the bits 2 b21 + b0 of all pixels: of a pixel's two dots, those with
;          b0 = 1, 0

        routine c2p_8_2x1_blit,a0
        wide_halves 1
