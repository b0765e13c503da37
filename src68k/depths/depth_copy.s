        include "depths.i"

; depth_copy - copies the pixels of a face whose q is z or more, and sets z to q there
;
; in:      a0  const depth_plan*  the lines, the bounds, the plane of q, where pixels are and go
; reads:   the plan, left and last of its lines and bounds, z and pixels
; writes:  z and pixels that are in the lines and the bounds, where q is z or more
; formats: as depth_fill; pixels of 1 byte
; error:   as depth_fill
; cost:    bench rows depth_copy, depth_copy_hidden; about 200 cycles a line
        routine depth_copy,a0
        depths_copy
.pixel  cmp.l   (a0)+,d1
        blt.s   .hidden
        move.l  d1,-4(a0)
        move.b  (a1)+,(a6)+
        add.l   d6,d1
        dbf     d3,.pixel
        bra     .next
.hidden addq.l  #1,a1
        addq.l  #1,a6
        add.l   d6,d1
        dbf     d3,.pixel
        depths_copied
