        include "depths.i"

pixel   macro
        cmp.l   4*\1(a0),d1
        blt.s   .hidden\@
        move.l  d1,4*\1(a0)
        move.b  \1(a1),\1(a6)
.hidden\@
        add.l   d6,d1
        endm

; depth_copy - copies the pixels of a face whose q is z or more, and sets z to q there
;
; in:      a0  const depth_plan*  the lines, the plane of q, where pixels are and go
; reads:   the plan, left and last of its lines, z and pixels; not its first and last
; writes:  z and pixels that are in the lines, where q is z or more
; formats: as depth_fill; pixels of 1 byte
; error:   as depth_fill
; cost:    bench rows depth_copy, depth_copy_hidden; about 250 cycles a line
        routine depth_copy,a0
        depths_copy pixel
