        include "planar.i"

; c2p_8 - a chunky frame as eight planes
;
; in:      a0  const planar_plan*  the pixels and the planes
; writes:  the rows of eight planes
; formats: 8-bit chunky pixels; the leftmost of 8 is a byte's highest bit

; 32 pixels are eight longwords, and so are their planes. At first bits 4 to 2 of a pixel's
; number select the longword; in the end the plane's number does. Merges by 16 and 2 put the
; pixel's bits 4 and 1 in their places and bring out the plane's bit 1, merges by 8 and 1 the
; pixel's bits 3 and 0 and the plane's bit 0, the merge by 4 the pixel's bit 2 and the plane's
; bit 2. All merges except the last need only every other longword, so the same code does them
; twice and the loop fits the instruction cache. Reading words together is faster than swapping.

        routine c2p_8,a0
        planar_open 0,3
        planar_row
.keep   keep_half
        addq.l  #4,a0
.longs  words   d0,d1,0
        words   d2,d3,8
        merge   d0,d2,8,d5
        merge   d1,d3,8,d5
        merge   d0,d1,2,d6
        merge   d2,d3,2,d6
        merge   d0,d2,1,d7
        merge   d1,d3,1,d7
        move.w  a0,d4
        lsr.w   #3,d4
        bcc     .keep                   ; after the even longwords
        move.l  #$f0f0f0f0,d5
        lea     28(a0),a0
        two_planes a3,d3
        adda.l  a2,a1
        two_planes a4,d1
        adda.l  a2,a1
        two_planes a5,d2
        adda.l  a2,a1
        two_planes a6,d0
        planar_next
