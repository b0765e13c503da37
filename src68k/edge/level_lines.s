        include "level.i"

; level_lines - starts and steps of lines of nearly constant depth, for the affine span
;
; in:      a0  perspective_plan*  the table, the planes; to and bend are not read
;          a1  scanline_step*     for the steps of u and v, one entry a line
; reads:   the plan, left and last of its lines
; writes:  start0, start1, start2 of the plan's lines, addx form, and their steps; not
;          those of empty lines
; formats: with q of the line's first pixel: u = base + s / q.hi, cut towards zero and
;          clamped to the plan's limits; with q of its last one, tilt a pixel further and not below
;          q_low: its step (ds - u tilt) / q.hi, u less its base, rounded up; 16.16. If the plan is chained and v
;          goes down, u goes a unit up, as much as each wrap of v takes.
;          What the plan's upper limit has taken from the first pixel is added to the steps, a part of a unit more
;          each, so that u is not below s / q.hi at the other pixels either
; error:   if q is the same all along the line: u a unit too low at the first pixel, a
;          unit higher at each other one, or two. Otherwise it is so at both ends, with the errors of the planes,
;          and between them off by about n^2 / (4 L) pixels, L = q / |tilt|

; Such a step leads to u of the last pixel: u + n (ds - u tilt) / (q + n tilt) is (s + n ds) / (q + n tilt),
; s being u q. Floors and walls seen by an upright camera are such polygons.

        routine level_lines,a0,a1
        save_all
        movea.l a0,a6
        movea.l a1,a5
        lea     walk_sizeof-level_sizeof(sp),sp
        walk_open
        lea     perspective_plan_s+screen_plane_dx(a6),a0
        lea     step_u(sp),a1
        bsr     level_make
        lea     perspective_plan_t+screen_plane_dx(a6),a0
        lea     step_v(sp),a1
        bsr     level_make
        moveq   #0,d0
        move.l  d0,taken_u(sp)
        move.l  d0,taken_v(sp)
        tst.l   perspective_plan_chained(a6)
        beq.s   .chain
        bset    #STEP_SIGN,d0
.chain  move.l  d0,chain_bit(sp)
        movea.l a5,a1
        movea.l perspective_plan_lines(a6),a0
        movea.l perspective_plan_left(a6),a5
        lea     EDGE_BIAS(a5),a5
        move.l  perspective_plan_count(a6),d0
        mulu.w  #scanline_sizeof,d0
        lea     (a0,d0.l),a3
        move.l  a3,lines_end(sp)
        movem.l walk_q(sp),d0-d5
.begin  tst.l   perspective_plan_tilt(a6)
        bne     .line1
        lines   0
        lines   1

        ; the last line, or one that the range has taken something from
.stop   regain  u,.v
        add.l   d6,scanline_step_dudx-scanline_step_sizeof(a1)
.v      regain  v,.more
        move.l  scanline_step_dvdx-scanline_step_sizeof(a1),d7
        add.l   d7,d6
        move.l  d6,scanline_step_dvdx-scanline_step_sizeof(a1)
        not.l   d7
        and.l   d7,d6
        and.l   chain_bit(sp),d6        ; v goes down only if it did so before
        beq.s   .more
        addq.l  #1,scanline_step_dudx-scanline_step_sizeof(a1)
.more   movea.l lines_end(sp),a3
        cmpa.l  a3,a0
        bne     .begin
        lea     level_sizeof(sp),sp
        return_all

        others  0
        others  1
        level_calls
        walk_turns
