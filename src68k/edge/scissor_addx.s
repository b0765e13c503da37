        include "scissor.i"
        include "chain.i"

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
