        include "routine.i"

; edge_exact - an edge by integer quotient and remainder, from any of its lines on
;
; in:      a0  edge*    the edge to fill in
;          a1  vertex*  upper end, 16.16
;          a2  vertex*  lower end, below the upper one
;          d1  int32    line, between the two
; trashes: d0-d7
; reads:   x, y of both ends
; writes:  edge: x, whole, error, part, height
; formats: with W x H the edge's extent and A = ceil(x's fraction * H + W * dy) in
;          units of H pixels: x = ceil(A / H) + whole part, error = 2^32 - 1 -
;          (that ceil * H - A), whole = floor(W / H), part = W modulo H
; error:   none: every ceil is the rational one
; cost:    about 320 cycles

; The numerator has 64 bits. Its part below 1/65536 is the same on every line, so its
; ceil is taken once.

        routine edge_exact
        swap    d1
        clr.w   d1
        sub.l   vertex_y(a1),d1         ; dy
        move.l  vertex_y(a2),d4
        sub.l   vertex_y(a1),d4         ; H
        move.l  vertex_x(a1),d7
        move.l  vertex_x(a2),d5
        sub.l   d7,d5                   ; W
        move.l  d5,d3
        muls.l  d1,d2:d3                ; W * dy
        moveq   #0,d0
        move.w  d7,d0
        mulu.l  d4,d1:d0                ; fraction * H
        add.l   d0,d3
        addx.l  d1,d2
        moveq   #0,d1
        add.l   #$ffff,d3
        addx.l  d1,d2
        move.w  d2,d3                   ; hhHH llLL >> 16: --hh HHll
        swap    d3
        swap    d2
        ext.l   d2
        divs.l  d4,d2:d3                ; d3 = A / H towards zero, d2 its remainder
        tst.l   d2
        ble.s   .ceil
        addq.l  #1,d3
        sub.l   d4,d2
.ceil   subq.l  #1,d2                   ; not (ceil * H - A)
        move.l  d2,edge_error(a0)
        swap    d7
        ext.l   d7
        add.l   d7,d3
        add.l   #EDGE_BIAS,d3
        move.l  d3,edge_x(a0)
        move.l  d4,edge_height(a0)
        divsl.l d4,d2:d5                ; d5 = W / H towards zero
        tst.l   d2
        bpl.s   .floor
        add.l   d4,d2
        subq.l  #1,d5
.floor  move.l  d2,edge_part(a0)
        move.l  d5,edge_whole(a0)
        rts
