        include "depths.i"

pixel   macro
        move.b  \1(a1),d0
        beq.s   .hidden\@
        cmp.l   4*\1(a0),d1
        blt.s   .hidden\@
        move.l  d1,4*\1(a0)
        move.b  d0,\1(a6)
.hidden\@
        add.l   d6,d1
        endm

; depth_copy_keyed - copies the pixels of a face that are not 0 and whose q is z or more, and sets z to q there
;
; like:    depth_copy
; cost:    bench row depth_copy_keyed; about 250 cycles a line
        routine depth_copy_keyed,a0
        depths_copy pixel
