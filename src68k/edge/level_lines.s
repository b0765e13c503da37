        include "chain.i"
        include "perspective.i"

; \1 = the step of \3, u or v in \4, a pixel: the 64-bit gradient of the plane \2 (s or t) less that of q times
; \3, over q in d7, rounded up; 0 if it does not fit. Uses d0-d2/d6.
step    macro
        movem.l perspective_plan_\2+screen_plane_dx(a6),d0-d1
        move.l  perspective_plan_tilt(a6),d2
        beq.s   .level\@
        move.l  \4,d6
        sub.l   perspective_plan_\3(a6),d6
        muls.l  d2,d2:d6
        move.b  d2,d6
        ror.l   #8,d6
        asr.l   #8,d2
        sub.l   d6,d1
        subx.l  d2,d0
.level\@
        move.l  d7,d2
        subq.l  #1,d2
        add.l   d2,d1
        bcc.s   .rounded\@
        addq.l  #1,d0
.rounded\@
        move.l  d0,d2
        minus   <not.l d2>
        add.l   d2,d2
        cmp.l   d7,d2
        bhs.s   .none\@                 ; more than the map: the line has a pixel or two
        divs.l  d7,d0:d1
        bvs.s   .none\@
        tst.l   d0
        minus   <subq.l #1,d1>
        move.l  d1,\1
        bra.s   .made\@
.none\@ clr.l   \1
.made\@
        endm

; On the stack.
taken_u equ     walk_sizeof             ; what the range takes from u of the line's first pixel
taken_v equ     walk_sizeof+4
lines_end equ   walk_sizeof+8

; Keeps what the range takes from d1, \1, and leaves the loop behind this line.
keep    macro
        sub.l   perspective_plan_\1_high(a6),d1
        move.l  d1,4+taken_\1(sp)
        lea     scanline_sizeof(a0),a3
        rts
        endm

; d0 = what each step of the line before a0 and a5 has to make up for in \1; goes to \2 if there is nothing to. Uses
; d1.
regain  macro
        move.l  taken_\1(sp),d0
        beq.s   \2
        clr.l   taken_\1(sp)
        moveq   #0,d1
        move.w  scanline_last-scanline_sizeof(a0),d1
        sub.w   scanline_left-scanline_sizeof(a0),d1
        beq.s   \2
        divu.l  d1,d0
        addq.l  #1,d0
        endm

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
        subq.l  #4,sp
        clr.l   -(sp)
        clr.l   -(sp)
        walk_open
        movea.l perspective_plan_lines(a6),a0
        movea.l perspective_plan_left(a6),a4
        lea     EDGE_BIAS(a4),a4
        move.l  perspective_plan_count(a6),d0
        mulu.w  #scanline_sizeof,d0
        lea     (a0,d0.l),a3
        move.l  a3,lines_end(sp)

.line   moveq   #0,d7
        move.w  scanline_left(a0),d7
        sub.l   a4,d7
        walk_to 0
        move.w  scanline_left(a0),d6
        cmp.w   scanline_last(a0),d6
        bgt     .next
        weight  d7
        move.l  d2,d0
        move.l  d3,d1
        quotient u,d7,keep_u
        add.l   perspective_plan_u(a6),d1
        move.l  d1,d3
        move.l  d4,d0
        move.l  d5,d1
        quotient v,d7,keep_v
        add.l   perspective_plan_v(a6),d1
        move.l  d1,d4

        move.l  perspective_plan_tilt(a6),d0
        beq.s   .level
        move.w  scanline_last(a0),d1
        sub.w   scanline_left(a0),d1
        ext.l   d1
        muls.l  d0,d0:d1
        move.b  d0,d1
        ror.l   #8,d1
        add.l   d1,d7                   ; q of the last pixel
        cmp.l   perspective_plan_q_low(a6),d7
        bge.s   .level
        move.l  perspective_plan_q_low(a6),d7
.level  step    scanline_step_dudx(a5),s,u,d3
        step    scanline_step_dvdx(a5),t,v,d4
        tst.l   perspective_plan_chained(a6)
        beq.s   .pack
        btst    #7,scanline_step_dvdx+1(a5)     ; the sign of v's step modulo 256
        beq.s   .pack
        addq.l  #1,scanline_step_dudx(a5)
.pack   pack_start d3,d4,d5,a0

.next   lea     scanline_sizeof(a0),a0
        addq.l  #scanline_step_sizeof,a5
        cmpa.l  a3,a0
        bne     .line

        ; the last line, or one that the range has taken something from
        regain  u,.v
        add.l   d0,scanline_step_dudx-scanline_step_sizeof(a5)
.v      regain  v,.more
        move.b  scanline_step_dvdx+1-scanline_step_sizeof(a5),d1
        add.l   d0,scanline_step_dvdx-scanline_step_sizeof(a5)
        not.b   d1
        and.b   scanline_step_dvdx+1-scanline_step_sizeof(a5),d1
        bpl.s   .more                   ; v goes down only if it did so before
        tst.l   perspective_plan_chained(a6)
        beq.s   .more
        addq.l  #1,scanline_step_dudx-scanline_step_sizeof(a5)
.more   movea.l lines_end(sp),a3
        cmpa.l  a3,a0
        bne     .line
        lea     walk_sizeof+12(sp),sp
        return_all

keep_u  keep    u
keep_v  keep    v
        walk_turns
