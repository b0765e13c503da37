        include "extent.i"

; edge_rounded - an edge in 16.16, from any of its lines on
;
; like:    edge_exact
; formats: slope = W / H to the nearest 1/65536 pixel a line, 0 if the edge has one line
;          only; x = x0 + W * prestep / H, to the nearest 1/65536, at the given line,
;          prestep being the distance down to it; whole and part are the slope's halves,
;          x and error those of x + EDGE_BIAS + 1 - 1/65536; height 0
; error:   of x, n lines below the given one: (n + 1) / 2^17 pixels
; cost:    about 340 cycles

        routine edge_rounded
        extent
        jmp     edge_rounded_across

; \1:\2 = its quotient by d5, to the nearest, halves up, in \2. d3 = d5 / 2, d1 = 0.
nearest macro
        add.l   d3,\2
        addx.l  d1,\1
        divs.l  d5,\1:\2                ; towards zero
        tst.l   \1
        minus   <subq.l #1,\2>
        endm

; edge_rounded_across - the same from the edge's extent
;
; like:    edge_exact_across
; formats: as edge_rounded
; error:   as edge_rounded
; cost:    about 290 cycles, 200 for one line

; The slope cannot overflow: an edge of two lines or more is more than one pixel high.
        routine edge_rounded_across
        move.l  d5,d3
        lsr.l   #1,d3
        moveq   #0,d0
        tst.l   d1
        beq.s   .on_line                ; as with integer edges
        move.l  d4,d0
        muls.l  d1,d2:d0
        moveq   #0,d1
        nearest d2,d0
.on_line
        add.l   d0,d7
        add.l   #(EDGE_BIAS<<16)+$ffff,d7
        moveq   #1,d0
        cmp.l   d0,d6
        beq.s   .one
        swap    d4
        move.w  d4,d0
        ext.l   d0
        clr.w   d4                      ; d0:d4 = W << 16
        moveq   #0,d1
        nearest d0,d4
        move.l  d4,d5
        swap    d5
        clr.w   d5
        swap    d4
        ext.l   d4
.place  move.l  d7,d3
        swap    d3
        clr.w   d3
        clr.w   d7
        swap    d7
        moveq   #0,d2
        movem.l d2-d5/d7,edge_height(a0)        ; error, whole, part, x
        rts
.one    moveq   #0,d4
        moveq   #0,d5
        bra.s   .place
