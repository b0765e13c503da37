; A line of a face and z: what depth_fill and depth_copy share.

        include "routine.i"

; a5 the plan, a2 the line, a3 its bounds, a4 its z, d4:d5 q at `left`, d6 the step, d7 lines to draw.
depths_begin macro
        save_all
        movea.l a0,a5
        movea.l depth_plan_lines(a5),a2
        movea.l depth_plan_bounds(a5),a3
        movea.l depth_plan_row(a5),a4
        movem.l depth_plan_at(a5),d4-d5
        move.l  depth_plan_step(a5),d6
        move.l  depth_plan_count(a5),d7
        endm

; d0 = the line's first pixel, d3 = its pixels less one; on to \1 if there are none. Uses d1.
depths_pixels macro
        moveq   #0,d0
        move.w  scanline_left(a2),d0
        cmp.w   scanline_left(a3),d0
        bcc.s   .left\@
        move.w  scanline_left(a3),d0
.left\@ move.w  scanline_last(a2),d3
        ext.l   d3
        move.w  scanline_last(a3),d1
        ext.l   d1
        cmp.l   d1,d3
        ble.s   .last\@
        move.l  d1,d3
.last\@ sub.l   d0,d3
        bmi     \1
        endm

; a0 = the z of pixel d0, d1 = its q. Uses d0/d2/a1.
depths_q macro
        lea     (a4,d0.l*4),a0
        sub.l   depth_plan_left(a5),d0
        movea.l d3,a1
        move.l  depth_plan_dx+number64_lo(a5),d2
        mulu.l  d0,d1:d2
        move.l  depth_plan_dx(a5),d3
        muls.l  d0,d3
        add.l   d5,d2
        addx.l  d4,d1
        add.l   d3,d1
        move.l  a1,d3
        endm

; On to the next line, at \1, or past the end.
depths_next macro
        lea     scanline_sizeof(a2),a2
        lea     scanline_sizeof(a3),a3
        adda.l  depth_plan_pitch(a5),a4
        add.l   depth_plan_dy+number64_lo(a5),d5
        move.l  depth_plan_dy(a5),d0
        addx.l  d0,d4
        subq.l  #1,d7
        bne     \1
        endm

; What copies begin with, for each line: a0 z, a1 pixels aside, a6 those of the frame, d1 q, d3 pixels less one.
depths_copy macro
        depths_begin
        move.l  depth_plan_from(a5),-(sp)
        move.l  depth_plan_to(a5),-(sp)
.line   depths_pixels .next
        movea.l 4(sp),a1
        adda.l  d0,a1
        movea.l (sp),a6
        adda.l  d0,a6
        move.l  a1,-(sp)
        depths_q
        movea.l (sp)+,a1
        endm

; What they end with.
depths_copied macro
.next   move.l  depth_plan_from_pitch(a5),d0
        add.l   d0,4(sp)
        move.l  depth_plan_to_pitch(a5),d0
        add.l   d0,(sp)
        depths_next .line
        addq.l  #8,sp
        return_all
        endm
