        include "clamp.i"

; d0 = the shade of the line's first pixel: a2 + left * \1.
on_plane macro
        moveq   #0,d0
        move.w  scanline_left(a4),d0
        muls.l  \1,d0
        add.l   a2,d0
        endm

packed  macro
        ror.l   #8,d0                   ; c-Cc
        add.l   a5,d0
        endm

; edge_shade - the shade of each line's first pixel, on the polygon's plane
;
; in:      a0  shade_plan*  the table, the plane, the range, where the shades go
; reads:   the plan, left and last of its lines
; writes:  the shades of lines with pixels, if inside is set of all lines; dcdx if the
;          longest line cannot stay in the range with it
; formats: levels 16.16 in multiples of 4 units: shade + line dcdy + left dcdx modulo
;          2^32. Unless the plan has inside set, moved as little as needed to keep all
;          pixels in the range low to high, both included, themselves 0 to 63.99.
;          Packed as c-Cc: the lower 8 of 16 bits of fraction, a spare byte, the level,
;          its fraction's upper byte; then the plan's added is added
; cost:    bench row edge_shade; with inside, edge_shade_inside
        routine edge_shade,a0
        save_all
        movea.l a0,a6
        movea.l shade_plan_lines(a6),a4
        movea.l shade_plan_shades(a6),a1
        movea.l shade_plan_shade(a6),a2
        movea.l shade_plan_dcdy(a6),a3
        movea.l shade_plan_added(a6),a5
        move.l  shade_plan_dcdx(a6),d3
        move.l  shade_plan_count(a6),d7
        tst.l   shade_plan_inside(a6)
        beq.s   .held

.inside on_plane d3
        packed
        move.l  d0,(a1)+
        adda.l  a3,a2
        lea     scanline_sizeof(a4),a4
        subq.l  #1,d7
        bne.s   .inside
        return_all

.held   move.l  d3,-(sp)
        move.l  d7,d6
        longest_line .limited
        limit   shade_plan_dcdx(a6),shade_plan_low(a6),shade_plan_high(a6),$fc
.limited
        movea.l shade_plan_lines(a6),a4
        move.l  shade_plan_count(a6),d7
        move.l  shade_plan_dcdx(a6),d3
        movem.l shade_plan_low(a6),d4-d5
.line   line_length .next
        on_plane (sp)
        clamp_line d0,d3,d4,d5
        packed
        move.l  d0,(a1)
.next   addq.l  #4,a1
        adda.l  a3,a2
        lea     scanline_sizeof(a4),a4
        subq.l  #1,d7
        bne.s   .line
        addq.l  #4,sp
        return_all
