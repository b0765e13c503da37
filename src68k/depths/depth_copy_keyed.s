        include "depths.i"

; depth_copy_keyed - copies the pixels of a face that are not 0 and whose q is z or more, and sets z to q there
;
; like:    depth_copy
; cost:    bench row depth_copy_keyed; about 200 cycles a line
        routine depth_copy_keyed,a0
        depths_copy
.pixel  move.b  (a1)+,d0
        beq.s   .hidden
        cmp.l   (a0),d1
        blt.s   .hidden
        move.l  d1,(a0)
        move.b  d0,(a6)
.hidden addq.l  #4,a0
        addq.l  #1,a6
        add.l   d6,d1
        dbf     d3,.pixel
        depths_copied
