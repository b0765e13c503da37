        include "planar.i"

; The planes \1 and \1 + 1 of 16 pixels, each bit twice, at the address \2: \1 has the two bits of each
; pixel side by side. Register instructions are between the stores. Trashes d4.
doubled macro
        move.l  \1,d4
        lsr.l   #1,d4
        eor.l   \1,d4
        and.l   d7,d4                   ; where the two bits differ
        eor.l   d4,\1
        move.l  \1,(\2,a2.l)
        eor.l   d4,\1
        add.l   d4,d4
        eor.l   d4,\1
        move.l  \1,(\2)+
        endm

; c2p_8_2x1 - a chunky frame as eight planes, each pixel two dots wide
;
; in:      a0  const planar_plan*  the pixels and the planes; a width that is a multiple of 16 will do
; writes:  the rows of eight planes
; formats: 8-bit chunky pixels; the leftmost of 8 is a byte's highest bit

; 16 pixels are four longwords, of which bits 3 and 2 of a pixel's number select one. Merges by 16 and 8
; exchange them with the pixel's bits 1 and 0, those by 4 and 2 these with the plane's bits 2 and 1. Then each
; longword has two planes' bits by turns.

        routine c2p_8_2x1,a0
        planar_open 0,2
        move.l  #$0f0f0f0f,d5
        lea     (a1,a2.l*2),a3
        lea     (a3,a2.l*2),a4
        lea     (a4,a2.l*2),a5
        places_row 0
.longs  words_16
        merge   d0,d2,8,#$00ff00ff
        merge   d1,d3,8,#$00ff00ff
        merge   d0,d1,4,d5
        merge   d2,d3,4,d5
        merge   d0,d2,2,d6
        doubled d0,a5
        doubled d2,a4
        merge   d1,d3,2,d6
        doubled d1,a3
        doubled d3,a1
        places_next 0,ROWS
        lea     LOCALS(sp),sp
        return_all
