; Boxes of pixels that outlines may cover.

        include "routine.i"

; Rounds \1 up to a whole number.
upwards macro
        add.l   #$ffff,\1
        swap    \1
        ext.l   \1
        endm

; \1 = the first pixel or line at or behind the coordinate \1, in the frame.
box_begin macro
        upwards \1
        bpl.s   .inside\@
        moveq   #0,\1
.inside\@
        endm

; \1 = the one behind the last before the coordinate \1, in a frame of \2.
box_end macro
        upwards \1
        cmp.l   \2,\1
        ble.s   .inside\@
        move.l  \2,\1
.inside\@
        endm
