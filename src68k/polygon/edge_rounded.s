        include "nearest.i"

; edge_rounded - an edge in 16.16, from any of its lines on
;
; like:    edge_exact
; formats: slope = W / H to the nearest 1/65536 pixel a line, 0 if the edge has one line
;          only; x = x0 + W * prestep / H, to the nearest 1/65536, at the given line,
;          prestep being the distance down to it; whole and part are the slope's halves,
;          x and error those of x + EDGE_BIAS + 1 - 1/65536; height 0
; error:   of x, n lines below the given one: (n + 1) / 2^17 pixels
; cost:    about 340 cycles

; The slope cannot overflow: two lines or more are more than one pixel high.

        routine edge_rounded
        move.l  vertex_y(a1),d5
        move.l  vertex_y(a2),d4
        move.l  d4,d3
        sub.l   d5,d4                   ; H
        move.l  vertex_x(a2),d0
        sub.l   vertex_x(a1),d0         ; W
        move.l  d4,d7
        lsr.l   #1,d7
        moveq   #0,d6
        move.l  d6,edge_height(a0)

        move.l  d5,d2
        add.l   #$ffff,d2
        clr.w   d2                      ; the edge's first line
        add.l   #$ffff,d3
        clr.w   d3
        sub.l   d2,d3                   ; lines
        swap    d1
        clr.w   d1
        sub.l   d5,d1                   ; prestep
        beq.s   .on_line                ; no prestep: as with integer edges
        muls.l  d1,d5:d0
        nearest d5,d0
        bra.s   .x
.on_line
        moveq   #0,d0
.x      add.l   vertex_x(a1),d0
        add.l   #(EDGE_BIAS<<16)+$ffff,d0
        cmp.l   #$10000,d3
        bls.s   .one_line               ; unsigned: up to 32,768 lines
        move.l  vertex_x(a2),d3
        sub.l   vertex_x(a1),d3
        swap    d3
        move.w  d3,d5
        ext.l   d5
        clr.w   d3                      ; d5:d3 = W << 16
        nearest d5,d3
        move.w  d3,d6
        swap    d6
        move.l  d6,edge_part(a0)
        swap    d3
        ext.l   d3
        move.l  d3,edge_whole(a0)
        bra.s   .place
.one_line
        move.l  d6,edge_part(a0)
        move.l  d6,edge_whole(a0)
.place  clr.l   edge_error(a0)
        move.w  d0,edge_error(a0)
        clr.w   d0
        swap    d0
        move.l  d0,edge_x(a0)
        rts
