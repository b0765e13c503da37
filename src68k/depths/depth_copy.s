        include "depths.i"

; Copies pixel \1 of four if it is seen; a0 goes on with each.
again   macro
        cmp.l   (a0)+,d1
        blt.s   .over\@
        move.l  d1,-4(a0)
        move.b  \1(a1),\1(a6)
.over\@ add.l   d6,d1
        endm

; depth_copy - copies the pixels of a face whose q is z or more, and sets z to q there
;
; in:      a0  const depth_plan*  the lines, the plane of q, where pixels are and go
; reads:   the plan, left and last of its lines, z and pixels; not its left and last
; writes:  z and pixels that are in the lines, where q is z or more
; formats: as depth_fill; pixels of 1 byte
; error:   as depth_fill
; cost:    bench rows depth_copy, depth_copy_hidden; about 250 cycles a line
        routine depth_copy,a0
        depths_copy
        addq.l  #1,d3
        moveq   #3,d2
        and.l   d3,d2
        lsr.l   #2,d3
        subq.w  #1,d2
        bmi.s   .fours
.one    cmp.l   (a0)+,d1
        blt.s   .hidden
        move.l  d1,-4(a0)
        move.b  (a1),(a6)
.hidden addq.l  #1,a1
        addq.l  #1,a6
        add.l   d6,d1
        dbf     d2,.one
.fours  subq.w  #1,d3
        bmi     .next
.four   move.l  d1,d0
        cmp.l   (a0),d1
        blt.s   .from_0
        move.l  d1,(a0)+
        add.l   d6,d1
        cmp.l   (a0),d1
        blt.s   .from_1
        move.l  d1,(a0)+
        add.l   d6,d1
        cmp.l   (a0),d1
        blt.s   .from_2
        move.l  d1,(a0)+
        add.l   d6,d1
        cmp.l   (a0),d1
        blt.s   .from_3
        move.l  d1,(a0)+
        add.l   d6,d1
        move.l  (a1)+,(a6)+             ; all four
        dbf     d3,.four
        bra.s   .next
.from_3 subq.l  #4,a0                   ; the four again, one by one: z may be q already
.from_2 subq.l  #4,a0
.from_1 subq.l  #4,a0
.from_0 move.l  d0,d1
        again   0
        again   1
        again   2
        again   3
        addq.l  #4,a1
        addq.l  #4,a6
        dbf     d3,.four
        depths_copied
