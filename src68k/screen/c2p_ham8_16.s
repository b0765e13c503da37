        include "routine.i"
        include "layout.i"
        include "planar.i"

;==============================================================================
; c2p_ham8_16 - an RGB565 frame as the colour planes of HAM8
;
; in:      a0  const planar_plan*  the pixels and the planes
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, the pixels
; writes:  the rows of planes 2 to 7
; formats: RGB565, four dots on the screen each: c/screen/planar.h
; error:   none: 5 bits become 6 by repeating the highest
; cost:    bench row c2p_ham8_16
;==============================================================================
; As c2p_ham8_32. Bits 0 and 1 of a colour's byte are whatever falls there: planes 0 and 1
; are not written.

        routine c2p_ham8_16,a0
        planar_open 1,2
        planar_row
.keep   keep_half
        addq.l  #2,a0
.longs  move.l  (a0),d0
        move.w  8(a0),d0                ; pixels 0, 4
        move.l  4(a0),d1
        move.w  12(a0),d1               ; 2, 6
        merge   d0,d1,8,d5              ; rrrrrggg, gggbbbbb of four pixels
        move.l  d0,d4
        lsl.l   #5,d4
        move.l  d1,d2
        lsr.l   #3,d2
        eor.l   d2,d4
        and.l   #$e0e0e0e0,d4
        eor.l   d4,d2                   ; gggggg--
        move.l  d0,d4
        lsr.l   #5,d4
        eor.l   d0,d4
        and.l   #$04040404,d4
        eor.l   d4,d0                   ; rrrrrr--
        move.l  d1,d4
        lsl.l   #3,d1
        lsr.l   #2,d4
        eor.l   d1,d4
        and.l   #$04040404,d4
        eor.l   d4,d1                   ; bbbbbb--
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
