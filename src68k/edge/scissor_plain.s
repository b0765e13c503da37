        include "scissor.i"

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

; scissor_plain - cuts a scanline table of the plain form to the frame's columns
;
; like:    scissor_addx
; formats: x with EDGE_BIAS, 0 to 32,769; start0 = uu, start1 = UU, start2 = VVvv
; error:   none: u, v as at the pixel on the uncut line
; cost:    about 45 cycles a line, 130 if its left end is cut
        routine scissor_plain,a0
        scissor start_plain
