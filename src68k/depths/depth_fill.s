        include "depths.i"

; depth_fill - sets z of a face's pixels in some columns to its q
;
; in:      a0  const depth_plan*  the lines, the columns, the plane of q
; reads:   the plan, left and last of its lines
; writes:  z of the pixels in both
; formats: q 32.32 modulo 2^64 at a line's first pixel, cut to 32 bits; from there on 32-bit steps
; error:   of q: less than one unit at a line's first pixel, and half a unit more a pixel
; cost:    bench row depth_fill; about 200 cycles a line
        routine depth_fill,a0
        depths_begin
        movem.l depth_plan_left(a5),a1/a3       ; and last
.line   move.l  a1,d0
        cmp.w   scanline_left(a2),d0
        bcc.s   .left
        move.w  scanline_left(a2),d0
.left   move.l  a3,d3
        cmp.w   scanline_last(a2),d3
        ble.s   .last
        move.w  scanline_last(a2),d3
        ext.l   d3
.last   sub.l   d0,d3
        bmi     .next
        depths_q
        lea     (a4,d0.l*4),a0
        addq.l  #1,d3
        move.l  d3,d2
        lsr.l   #2,d3
        beq.s   .rest
        subq.l  #1,d3
.four   move.l  d1,(a0)+
        add.l   d6,d1
        move.l  d1,(a0)+
        add.l   d6,d1
        move.l  d1,(a0)+
        add.l   d6,d1
        move.l  d1,(a0)+
        add.l   d6,d1
        dbf     d3,.four
.rest   andi.w  #3,d2
        beq.s   .next
        subq.w  #1,d2
.one    move.l  d1,(a0)+
        add.l   d6,d1
        dbf     d2,.one
.next   depths_next .line
        return_all
