        include "routine.i"
        include "layout.i"
        include "planar.i"

;==============================================================================
; c2p_ham8_5551 - an RGBA5551 frame as the colour planes of HAM8
;
; in:      a0  const planar_plan*  the pixels and the planes
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, the pixels
; writes:  the rows of planes 2 to 7
; formats: RGBA5551, alpha does not count; four dots on the screen each: c/screen/planar.h
; error:   none: 5 bits become 6 by repeating the highest
; cost:    bench row c2p_ham8_5551
;==============================================================================
; As c2p_ham8_16, but for where the bits are.

        routine c2p_ham8_5551,a0
        planar_open 1,2
        planar_row
.keep   keep_half
        addq.l  #2,a0
.longs  colours_5551
        merge_blue
        merge   d0,d2,1,d7
        merge   d1,d3,1,d7
        move.w  a0,d4
        lsr.w   #2,d4
        bcc     .keep                   ; of the even pixels
        move.l  #$f0f0f0f0,d5
        lea     14(a0),a0
        six_planes
        planar_next
