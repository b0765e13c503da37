        include "planar.i"

; c2p_8_2x1_blits - a chunky frame as four half planes, which the blitter merges by 2 and doubles
;
; in:      a0  const planar_plan*  the pixels and the half planes; a width that is a multiple of 16 will do
; writes:  the rows of four half planes
; formats: 8-bit chunky pixels; half plane 2 b2 + p0 has the bits 4 b2 + 2 b1 + b0 of pixels whose number has p0 as
;          bit 0: of four dots, those with b1 b0 = 11, 10, 01, 00

        routine c2p_8_2x1_blits,a0
        planar_open 0,2
        move.l  #$0f0f0f0f,d6
        lea     (a1,a2.l),a3
        lea     (a1,a2.l*2),a4
        lea     (a3,a2.l*2),a5
        places_row 0
.longs  words_16
        merge   d0,d2,8,d5
        merge   d1,d3,8,d5
        merge   d0,d1,4,d6
        move.l  d0,(a4)+
        merge   d2,d3,4,d6
        move.l  d1,(a1)+
        move.l  d2,(a5)+
        move.l  d3,(a3)+
        places_next 0,ROWS
        lea     LOCALS(sp),sp
        return_all
