        include "ham8.i"

; c2p_ham8_32 - an RGBA8888 frame as the colour planes of HAM8
;
; in:      a0  const planar_plan*  the pixels and the planes
; writes:  the rows of planes 2 to 7
; formats: R G B A, four dots on the screen each: c/screen/planar.h
; error:   the lower two bits of R, G and B are dropped; A is ignored

; As c2p_8, on eight pixels whose four bytes are the values of four dots, with B instead of A.

        routine c2p_ham8_32,a0
        planar_open 2,3
        planar_row
.keep   keep_half
        addq.l  #4,a0
.longs  words   d0,d1,0
        words   d2,d3,8
        merge   d0,d2,8,d5              ; RRRR, GGGG
        lsr.l   #8,d3
        eor.l   d1,d3
        and.l   d5,d3
        eor.l   d3,d1                   ; BBBB
        merge_blue
        merge   d0,d2,1,d7
        merge   d1,d3,1,d7
        move.w  a0,d4
        lsr.w   #3,d4
        bcc     .keep                   ; after the even pixels
        move.l  #$f0f0f0f0,d5
        lea     28(a0),a0
        six_planes
        planar_next
