; Parts shared by the conversions to HAM8.

        include "planar.i"

; The last merge, as two_planes, but writes only the second of the two planes.
upper_plane macro
        move.l  \1,d4
        lsr.l   #4,\2
        eor.l   \2,d4
        and.l   d5,d4
        eor.l   d4,\2
        move.l  \2,(a1,a2.l*4)
        endm

; d0 = the upper bytes, d1 = the lower bytes of four 16-bit pixels: 0, 2, 4, 6 from a0 on.
; Trashes d4.
bytes_16 macro
        move.l  (a0),d0
        move.w  8(a0),d0                ; pixels 0, 4
        move.l  4(a0),d1
        move.w  12(a0),d1               ; 2, 6
        merge   d0,d1,8,d5
        endm

; Replaces the bits of \1 in the mask \2 by those of d4. Trashes d4.
choose  macro
        eor.l   \1,d4
        and.l   #\2,d4
        eor.l   d4,\1
        endm

; Four pixels of RGB565: d0 = reds, d2 = greens, d1 = blues, in the upper six bits of each
; byte; of five bits the highest is repeated as the sixth. d0, d1 are rrrrrggg, gggbbbbb first.
colours_565 macro
        bytes_16
        move.l  d0,d4
        lsl.l   #5,d4
        move.l  d1,d2
        lsr.l   #3,d2
        choose  d2,$e0e0e0e0            ; gggggg--
        move.l  d0,d4
        lsr.l   #5,d4
        choose  d0,$04040404            ; rrrrrr--
        move.l  d1,d4
        lsl.l   #3,d1
        lsr.l   #2,d4
        choose  d1,$04040404            ; bbbbbb--
        endm

; The same for RGBA5551: d0, d1 are rrrrrggg, ggbbbbba first.
colours_5551 macro
        bytes_16
        move.l  d0,d4
        lsl.l   #5,d4
        move.l  d1,d2
        lsr.l   #3,d2
        choose  d2,$e0e0e0e0
        move.l  d0,d4
        choose  d2,$04040404            ; gggggg--
        move.l  d0,d4
        lsr.l   #5,d4
        choose  d0,$04040404            ; rrrrrr--
        move.l  d1,d4
        lsl.l   #2,d1
        lsr.l   #3,d4
        choose  d1,$04040404            ; bbbbbb--
        endm

; The four bytes of each pixel are red, green, blue and blue: exchanges pixel bit 1 and plane
; bit 1 of d0 = reds, d2 = greens and d1 = blues; the two blues end in d1 and d3.
merge_blue macro
        move.l  d1,d3
        lsr.l   #2,d3
        move.l  d3,d4
        eor.l   d0,d4
        and.l   d6,d4
        eor.l   d4,d0
        eor.l   d2,d3
        and.l   d6,d3
        eor.l   d3,d2
        lsl.l   #2,d3
        eor.l   d1,d3
        lsl.l   #2,d4
        eor.l   d4,d1
        endm

; Writes the six upper planes of the pixels' bytes.
six_planes macro
        upper_plane a3,d3
        adda.l  a2,a1
        upper_plane a4,d1
        adda.l  a2,a1
        two_planes a5,d2
        adda.l  a2,a1
        two_planes a6,d0
        endm

; Converts a frame of 16 bits a pixel to the colour planes of HAM8. \1: the macro that separates
; the colours.
ham8_rows_16 macro
        planar_open 1,2
        planar_row
.keep   keep_half
        addq.l  #2,a0
.longs  \1
        merge_blue
        merge   d0,d2,1,d7
        merge   d1,d3,1,d7
        move.w  a0,d4
        lsr.w   #2,d4
        bcc     .keep                   ; after the even pixels
        move.l  #$f0f0f0f0,d5
        lea     14(a0),a0
        six_planes
        planar_next
        endm
