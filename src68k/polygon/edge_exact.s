        include "extent.i"

; edge_exact - an edge by integer quotient and remainder, from any of its lines on
;
; in:      a0  edge*    the edge to fill in
;          a1  vertex*  upper end, 16.16
;          a2  vertex*  lower end, below the upper one
;          d1  int32    line, between the two
; trashes: d0-d7
; reads:   x, y of both ends; lines of the edge
; writes:  edge: x, whole, error, part, height
; formats: with W x H the edge's extent and A = ceil(x's fraction * H + W * dy) in
;          units of H pixels: x = ceil(A / H) + whole part, error = 2^32 - 1 -
;          (that ceil * H - A), whole = floor(W / H), part = W modulo H; both 0 for one line
; error:   none: every ceil is the rational one
; cost:    about 320 cycles

; The numerator has 64 bits. Its part below 1/65536 is the same on every line, so its
; ceil is taken once.

        routine edge_exact
        extent
        jmp     edge_exact_across

; edge_exact_across - the same from the edge's extent
;
; in:      a0  edge*   the edge to fill in
;          d1  int32   from the upper end down to the first line, dy
;          d4  int32   width, W
;          d5  int32   height, H, above 0
;          d6  int32   lines
;          d7  fix16   x of the upper end
; trashes: d0-d5/d7
; writes:  as edge_exact
; formats: as edge_exact
; cost:    about 280 cycles, 220 if the edge is less than 45 degrees from upright, 200 for one line
        routine edge_exact_across
        move.l  d4,d3
        muls.l  d1,d2:d3                ; W * dy
        moveq   #0,d0
        move.w  d7,d0
        mulu.l  d5,d1:d0                ; fraction * H
        add.l   d0,d3
        addx.l  d1,d2
        moveq   #0,d1
        add.l   #$ffff,d3
        addx.l  d1,d2
        move.w  d2,d3                   ; hhHH llLL >> 16: --hh HHll
        swap    d3
        swap    d2
        ext.l   d2
        divs.l  d5,d2:d3                ; d3 = A / H towards zero, d2 its remainder
        tst.l   d2
        ble.s   .ceil
        addq.l  #1,d3
        sub.l   d5,d2
.ceil   swap    d7
        ext.l   d7
        add.l   d3,d7
        add.l   #EDGE_BIAS,d7
        move.l  d2,d3
        subq.l  #1,d3                   ; not (ceil * H - A)
        moveq   #1,d0
        cmp.l   d0,d6
        beq.s   .one
        move.l  d4,d2
        bmi.s   .back
        moveq   #0,d4
        cmp.l   d5,d2
        blt.s   .floor
        move.l  d2,d4
        bra.s   .divide
.back   moveq   #-1,d4
        add.l   d5,d2
        bpl.s   .floor
        move.l  d2,d4
        sub.l   d5,d4
.divide divsl.l d5,d2:d4                ; d4 = W / H towards zero
        tst.l   d2
        bpl.s   .floor
        add.l   d5,d2
        subq.l  #1,d4
.floor  exg     d2,d5
        movem.l d2-d5/d7,edge_height(a0)        ; error, whole, part, x
        rts
.one    moveq   #0,d4
        move.l  d5,d2
        moveq   #0,d5
        movem.l d2-d5/d7,edge_height(a0)
        rts
