        include "ham8.i"

; c2p_ham8_5551 - an RGBA5551 frame as the colour planes of HAM8
;
; like:    c2p_ham8_32
; formats: RGBA5551, alpha is ignored; four dots on the screen each: c/screen/planar.h
; error:   none: 5 bits become 6 by repeating the highest

; As c2p_ham8_16, with the bits at other places.

        routine c2p_ham8_5551,a0
        ham8_rows_16 colours_5551
