        include "routine.i"

        xref    longest_find,crossings_find

; three_longest - a triangle's steps from its longest scanline, and starts where left edges cross the lines
;
; in:      a0  three*  the plan of its material, with the triangle's sides, box and edges
; trashes: d0-d7/a0-a6
; reads:   the plan
; writes:  texturing and left edges of the plan's setup
; formats: those of longest_find and crossings_find
; error:   theirs
; cost:    theirs, and 60 cycles
        routine three_longest
        movea.l a0,a6
        lea     setup_texturing(a6),a0
        lea     setup_sides(a6),a1
        moveq   #CHAIN_ANYWHERE,d1
        moveq   #THREE_SHADES,d0
        cmp.l   three_way(a6),d0
        bne.s   .chained
        moveq   #CHAIN_NONE,d1
.chained
        move.l  a6,d0
        add.l   #setup_box,d0
        jsr     longest_find
        movea.l setup_edges+edge_plan_left(a6),a1
        move.l  setup_edges+edge_plan_lefts(a6),d0
        move.l  setup_box+rectangle_right(a6),d1
        sub.l   setup_box+rectangle_left(a6),d1
        jmp     crossings_find
