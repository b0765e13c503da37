        include "routine.i"
        include "layout.i"
        include "planar.i"

;==============================================================================
; c2p_ham8_5551 - an RGBA5551 frame as the colour planes of HAM8
;
; in:      a0  const planar_plan*  the pixels and the planes
; reads:   the plan, the pixels
; writes:  the rows of planes 2 to 7
; formats: RGBA5551, alpha is ignored; four dots on the screen each: c/screen/planar.h
; error:   none: 5 bits become 6 by repeating the highest
; cost:    bench row c2p_ham8_5551
;==============================================================================
; As c2p_ham8_16, with the bits at other places.

        routine c2p_ham8_5551,a0
        ham8_rows_16 colours_5551
