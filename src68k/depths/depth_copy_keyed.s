        include "depths.i"

PIXELS  equ     8

; Copies pixel \1, from 1 to PIXELS, with as many bytes each time.
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
; cost:    bench row depth_copy_keyed; about 300 cycles a line
        routine depth_copy_keyed,a0
        depths_copy
        moveq   #PIXELS-1,d2            ; the first time without so many
        and.l   d3,d2
        eori.w  #PIXELS-1,d2
        lsr.l   #3,d3
        suba.l  d2,a1
        suba.l  d2,a6
        move.l  d2,d0
        lsl.l   #2,d0
        suba.l  d0,a0
        subq.l  #4,a0
        subq.l  #1,a1
        subq.l  #1,a6
        muls.w  #.second-.first,d2
        jmp     .first(pc,d2.l)
.first  pixel   1
.second pixel   2
        pixel   3
        pixel   4
        pixel   5
        pixel   6
        pixel   7
        pixel   8
        lea     4*PIXELS(a0),a0
        addq.l  #PIXELS,a1
        addq.l  #PIXELS,a6
        dbf     d3,.first
        depths_copied
