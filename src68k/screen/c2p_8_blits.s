        include "planar.i"

; c2p_8_blits - a chunky frame as eight quarter planes, which the blitter merges by 1 and by 2
;
; in:      a0  const planar_plan*  the pixels and the quarter planes
; writes:  the rows of eight quarter planes
; formats: 8-bit chunky pixels; quarter plane 4 b2 + 2 p1 + 1 - p0 has the bits 4 b2 + 2 b1 + b0 of pixels whose number has
;          p1 p0 as bits 1 and 0: where bit 1 of a dot's number is 1, those with b1 = 0, where bit 0 is 1, those with b0 = 0

        routine c2p_8_blits,a0
        half_planes 0
