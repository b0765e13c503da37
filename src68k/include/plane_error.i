; How far planes through rounded corners may be off.

        include "routine.i"

TOO_STEEP       equ     1<<28           ; 4 times this is above every q but the nearest's
GENTLE          equ     1<<14           ; in 2^16 units a pixel

; d0 = the units that the plane at \2 may be off after d2 pixels in the direction \1; d7 = 0 if its step is not
; gentle. Uses d1-d2.
error_part macro
        movem.l screen_plane_\1(\2),d0-d1
        tst.l   d0
        bpl.s   .magnitude\@
        tst.l   d1
        beq.s   .whole\@
        not.l   d0
        bra.s   .magnitude\@
.whole\@
        neg.l   d0
.magnitude\@
        cmp.l   #GENTLE,d0
        blt.s   .gentle\@
        moveq   #0,d7
        cmp.l   #$10000,d0
        blt.s   .gentle\@
        moveq   #15,d1
        asr.l   d1,d0
        addq.l  #1,d0
        move.l  #TOO_STEEP,d1
        divs.l  d2,d1
        cmp.l   d1,d0
        bgt.s   .too\@
        muls.l  d2,d0
        bra.s   .sum\@
.too\@  move.l  #TOO_STEEP,d0
        bra.s   .found\@
.gentle\@
        muls.l  d2,d0
        moveq   #15,d1
        asr.l   d1,d0
.sum\@  moveq   #14,d1
        asr.l   d1,d2
        add.l   d2,d0
        addq.l  #2,d0
.found\@
        endm
