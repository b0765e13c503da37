; The passes of texture units' lines.

        include "routine.i"

; Calls the passes of the list at a4, d4 + 1 of them, with d6 pixels that are at d5; d3 = PIXEL_PLACES: addresses
; below it are bytes from d5 on. A pass is four longs: input, output, constants, routine. Uses d0-d1/a0-a3.
call_passes macro
.stage\@
        movem.l (a4)+,a0-a3
        cmpa.l  d3,a0
        bhs.s   .in\@
        adda.l  d5,a0
.in\@   cmpa.l  d3,a1
        bhs.s   .out\@
        adda.l  d5,a1
.out\@  move.l  d6,d0
        jsr     PASS_SAVED(a3)
        dbra    d4,.stage\@
        endm

PIXEL_PLACES    equ     GLIDE_PIXEL_PLACES      ; for the N64's, null is the only one
