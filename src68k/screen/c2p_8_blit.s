        include "planar.i"

HELD    equ     12                      ; bytes on the stack above planar_open's

; c2p_8_blit - a chunky frame as eight half planes, which the blitter merges by 2
;
; in:      a0  const planar_plan*  the pixels and the half planes
; writes:  the rows of eight half planes
; formats: 8-bit chunky pixels; half plane 4 b2 + 2 p1 + b0 has the bits 4 b2 + 2 b1 + b0 of pixels whose number has
;          p1 as bit 1: where bit 1 of a dot's number is 1, those with b1 = 0

; Without the merge by 2, bit 1 of a pixel's number meets no other bit: even words of the frame and odd ones are
; converted one after the other, by four registers. Merges exchange its bit 4 and bit 1's place (by words), 3 and 0,
; 2 and the plane's bit 2, 0 and the plane's bit 0.

        routine c2p_8_blit,a0
        planar_open 0,3
        move.l  #$0f0f0f0f,d6
        movem.l a0/a1,-(sp)
        bsr.s   half
        movem.l (sp),a0/a1
        addq.l  #2,a0
        lea     (a1,a2.l*2),a1
        bsr.s   half
        lea     LOCALS+8(sp),sp
        return_all

; Words from a0 on, 4 bytes apart, to a1 and half planes behind it.
half    move.l  ROWS+HELD(sp),BACK+HELD(sp)
        lea     (a1,a2.l),a3
        lea     (a1,a2.l*4),a4
        lea     (a3,a2.l*4),a5
        places_row HELD
.longs  movem.l (a0)+,d0-d3
        move.w  (a0),d0
        move.w  4(a0),d1
        move.w  8(a0),d2
        move.w  12(a0),d3
        lea     16(a0),a0
        merge   d0,d2,8,d5
        merge   d1,d3,8,d5
        merge   d0,d1,4,d6
        merge   d2,d3,4,d6
        merge   d0,d2,1,d7
        move.l  d0,(a5)+
        merge   d1,d3,1,d7
        move.l  d2,(a4)+
        move.l  d1,(a3)+
        move.l  d3,(a1)+
        places_next HELD,BACK
        rts
