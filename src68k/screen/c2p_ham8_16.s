        include "ham8.i"

; c2p_ham8_16 - an RGB565 frame as the colour planes of HAM8
;
; like:    c2p_ham8_32
; formats: RGB565, four dots on the screen each: c/screen/planar.h
; error:   none: 5 bits become 6 by repeating the highest

; As c2p_ham8_32. Bits 0 and 1 of a colour's byte are undefined, as planes 0 and 1 are not
; written.

        routine c2p_ham8_16,a0
        ham8_rows_16 colours_565
