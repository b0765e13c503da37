        include "planar.i"

; c2p_8_2x1_blit - a chunky frame as four half planes, which the blitter doubles
;
; in:      a0  const planar_plan*  the pixels and the half planes; a width that is a multiple of 16 will do
; writes:  the rows of four half planes
; formats: 8-bit chunky pixels; half plane b21 has the bits 2 b21 + b0 of all pixels: of a pixel's two dots, those with
;          b0 = 1, 0

        routine c2p_8_2x1_blit,a0
        planar_open 0,2
        move.l  #$0f0f0f0f,d7
        lea     (a1,a2.l),a3
        lea     (a1,a2.l*2),a4
        lea     (a3,a2.l*2),a5
        places_row 0
.longs  words_16
        merge   d0,d2,8,d5
        merge   d1,d3,8,d5
        merge   d0,d1,4,d7
        merge   d2,d3,4,d7
        merge   d0,d2,2,d6
        move.l  d0,(a5)+
        merge   d1,d3,2,d6
        move.l  d2,(a4)+
        move.l  d1,(a3)+
        move.l  d3,(a1)+
        places_next 0,ROWS
        lea     LOCALS(sp),sp
        return_all
