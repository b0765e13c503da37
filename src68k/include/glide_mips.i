; Parts of the passes that find a level for each pixel (structs: c/glide/passes.h).

        include "n64.i"

; d0 = the next pixel's s:t, d1 = its level's half, d2 = mask, d5 = columns_bits : shift, a2 = texels;
; moves a0 and the LODs \1. In: a4 = levels. Uses d3.

; Coordinates of level k have 12 - k bits in use, as a map has 256 texels at most. A shift by n leaves
; 12 - k - n of them. Bits of s that enter t are above its 16 - n, where the mask is clear.
mip_open macro
        moveq   #0,d3
        move.b  (\1),d3                 ; the LOD's integer
        addq.l  #2,\1
        add.w   d3,d3
        move.l  (a0)+,d0
        lea     (a4,d3.w*8),a2
        movem.l (a2),d1-d3/d5
        adda.l  d3,a2
        endm
