        include "chain.i"

; Cuts the lines of a table to the frame's columns. \1: the macro that moves the start of
; the line d3 pixels to the right; a4 is the entry, a2 dudx, a3 dvdx, d0-d2/d4-d5 free.
scissor macro
        save_all
        movea.l scissor_plan_lines(a0),a4
        move.l  scissor_plan_count(a0),d7
        movea.l scissor_plan_dudx(a0),a2
        movea.l scissor_plan_dvdx(a0),a3
        move.w  scissor_plan_width+2(a0),d6
        add.w   #EDGE_BIAS-1,d6
        subq.l  #1,d7
.line   move.l  scanline_left(a4),d0    ; and last
        move.l  d0,d3
        swap    d3
        cmp.w   d3,d6
        blo.s   .outside
        addq.w  #1,d0                   ; unsigned: last may be -1, or 32,768
        cmp.w   d6,d0
        bhi.s   .right
.left   sub.w   #EDGE_BIAS,d3
        blo.s   .before
.next   lea     scanline_sizeof(a4),a4
        dbra    d7,.line
        return_all
.right  move.w  d6,scanline_last(a4)
        bra.s   .left
.before neg.w   d3                      ; pixels beyond the left border
        move.w  #EDGE_BIAS,scanline_left(a4)
        ext.l   d3
        \1
        bra.s   .next
.outside
        move.l  #EDGE_BIAS<<16+EDGE_BIAS-1,scanline_left(a4)    ; and last
        bra.s   .next
        endm

start_flat macro
        endm

start_plain macro
        move.w  scanline_start1(a4),d0
        swap    d0
        move.w  scanline_start0(a4),d0  ; UUuu
        move.l  a2,d1
        muls.l  d3,d1
        add.l   d1,d0
        move.w  d0,scanline_start0(a4)
        swap    d0
        move.w  d0,scanline_start1(a4)
        move.l  a3,d1
        muls.l  d3,d1
        add.l   d1,scanline_start2(a4)
        endm

start_addx macro
        moveq   #0,d0
        move.b  scanline_start2+3(a4),d0
        swap    d0
        move.w  scanline_start0(a4),d0  ; -Uuu
        move.w  scanline_start1(a4),d4
        lsl.l   #8,d4
        move.b  scanline_start2(a4),d4  ; -Vvv: the upper byte is ignored
        move.l  a2,d1
        muls.l  d3,d1
        add.l   d1,d0
        move.l  a3,d1
        muls.l  d3,d1
        add.l   d1,d4
        pack_start d0,d4,d1,a4
        endm

; scissor_flat - cuts a scanline table without u and v to the frame's columns
;
; in:      a0  scissor_plan*  the table and the frame's width
; reads:   the plan, left and last of its lines
; writes:  left and last of its lines
; formats: x with EDGE_BIAS, 0 to 32,769; of a line wholly outside last is below left
; cost:    about 45 cycles a line
        routine scissor_flat,a0
        scissor start_flat

; scissor_addx - cuts a scanline table of the addx form to the frame's columns
;
; in:      a0  scissor_plan*  the table, the frame's width, the gradients
; reads:   the plan, its lines
; writes:  its lines: the start follows the first pixel
; formats: x with EDGE_BIAS, 0 to 32,769; start0 = uu, start1 = Vv, start2 = v--U
; error:   none: u, v as at the pixel on the uncut line, modulo 256
; cost:    about 45 cycles a line, 180 if its left end is cut
        routine scissor_addx,a0
        scissor start_addx

; scissor_plain - cuts a scanline table of the plain form to the frame's columns
;
; like:    scissor_addx
; formats: x with EDGE_BIAS, 0 to 32,769; start0 = uu, start1 = UU, start2 = VVvv
; error:   none: u, v as at the pixel on the uncut line
; cost:    about 45 cycles a line, 130 if its left end is cut
        routine scissor_plain,a0
        scissor start_plain
