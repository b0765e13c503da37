        include "planar.i"

; c2p_8_2x1_blits - a chunky frame as four half planes, which the blitter merges by 2 and doubles
;
; in:      a0  const planar_plan*  the pixels and the half planes; a width that is a multiple of 16 will do
; writes:  the rows of four half planes
; formats: 8-bit chunky pixels; half plane 2 b2 + p0 has the bits 4 b2 + 2 b1 + b0 of pixels whose number has p0 as
;          bit 0: of four dots, those with b1 b0 = 11, 10, 01, 00

        routine c2p_8_2x1_blits,a0
        wide_halves 0
