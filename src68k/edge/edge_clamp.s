        include "clamp.i"

; edge_clamp - moves the starts of a table's lines so that no pixel leaves a range of u and v
;
; in:      a0  clamp_plan*  the table, the steps, the ranges
; reads:   the plan, its lines
; writes:  start0, start1, start2 of the lines (plain form); dudx, dvdx if the longest
;          line cannot stay in the range with them
; formats: u, v, ranges 16.16; both ends of a range belong to it
; error:   none: a line that was inside is unchanged, the start of another one moves as
;          little as possible. With both ends inside, so is every pixel between
; cost:    about 130 cycles a line
        routine edge_clamp,a0
        save_all
        movea.l a0,a6

        ; the longest line
        movea.l clamp_plan_lines(a6),a4
        move.l  clamp_plan_count(a6),d6
        longest_line .limited
        limit   clamp_plan_dudx(a6),clamp_plan_u_low(a6),clamp_plan_u_high(a6)
        limit   clamp_plan_dvdx(a6),clamp_plan_v_low(a6),clamp_plan_v_high(a6)
.limited
        movea.l clamp_plan_lines(a6),a4
        move.l  clamp_plan_count(a6),d7
        movem.l clamp_plan_u_low(a6),d4-d5
        movea.l clamp_plan_v_low(a6),a2
        movea.l clamp_plan_v_high(a6),a3
        movea.l clamp_plan_dudx(a6),a0
        movea.l clamp_plan_dvdx(a6),a1
.line   line_length .next
        move.w  scanline_start1(a4),d0
        swap    d0
        move.w  scanline_start0(a4),d0
        clamp_line d0,a0,d4,d5
        move.w  d0,scanline_start0(a4)
        swap    d0
        move.w  d0,scanline_start1(a4)
        move.l  scanline_start2(a4),d0
        clamp_line d0,a1,a2,a3
        move.l  d0,scanline_start2(a4)
.next   lea     scanline_sizeof(a4),a4
        subq.l  #1,d7
        bne     .line
        return_all
