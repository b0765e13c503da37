        include "planar.i"

; c2p_8_blit - a chunky frame as eight half planes, which the blitter merges by 2
;
; in:      a0  const planar_plan*  the pixels and the half planes
; writes:  the rows of eight half planes
; formats: 8-bit chunky pixels; half plane 4 b2 + 2 p1 + b0 has the bits 4 b2 + 2 b1 + b0 of pixels whose number has
;          p1 as bit 1: where bit 1 of a dot's number is 1, those with b1 = 0

        routine c2p_8_blit,a0
        half_planes 1
