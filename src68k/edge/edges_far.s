        include "routine.i"

; edges_far - lines of a polygon from its edges, for spans that begin at the far end
;
; in:      a0  far_edges*  both sides and their edges
; reads:   the edges of both sides: lines, x, whole, error, part and height
; writes:  the place's lines
; formats: q modulo 2^32, of the far edge's x on each line; x is where edge_flat_exact has it, an edge of height 0
;          as edge_flat has it
        routine edges_far,a0
        save_all
        movea.l a0,a2
        pea     edges_kept(pc)
        xdef    edges_far_inside,_edges_far_inside
; As edges_far, of a2; keeps a2.
_edges_far_inside
edges_far_inside
        movea.l far_edges_place+far_place_lines(a2),a0
        movea.l far_edges_far(a2),a6
        movea.l far_edges_place+far_place_row(a2),a3
        movea.l far_edges_place+far_place_q(a2),a5
        move.l  far_edges_fars(a2),-(sp)

        ; a0 line  a1 part  a2 edges  a3 row  a4 step of x  a5 q at x = 0  a6 edge
        ; d0 error  d1 x  d2 q  d3 lines  d4 height  d5 step of q  d6 the same a pixel on
.far    movea.l far_edges_place+far_place_pitch(a2),a4
        move.l  edge_lines(a6),d3
        move.l  edge_x(a6),d1
        move.l  far_edges_place+far_place_dqdx(a2),d6
        move.l  d1,d2
        muls.l  d6,d2
        add.l   a5,d2
        add.l   a3,d1
        move.l  edge_whole(a6),d5
        adda.l  d5,a4
        muls.l  d6,d5
        add.l   far_edges_place+far_place_dqdy(a2),d5
        add.l   d5,d6
        move.l  edge_error(a6),d0
        movea.l edge_part(a6),a1
        move.l  edge_height(a6),d4
        subq.w  #1,d3
        bra.s   .first
.more   sub.l   d4,d0
        add.l   d6,d2
        add.l   a4,d1
        addq.l  #1,d1
        bra.s   .first
.line   add.l   d5,d2
        add.l   a4,d1
.first  move.l  d2,(a0)+
        move.l  d1,(a0)+
        addq.l  #4,a0
        add.l   a1,d0
        dbcs    d3,.line
        bcc.s   .done
        dbra    d3,.more
.done   subq.l  #1,(sp)
        beq.s   .fars
        move.l  edge_lines(a6),d0       ; on to the next edge's first line
        move.l  far_edges_place+far_place_dqdy(a2),d1
        muls.l  d0,d1
        adda.l  d1,a5
        muls.l  far_edges_place+far_place_pitch(a2),d0
        adda.l  d0,a3
        lea     edge_sizeof(a6),a6
        bra.s   .far
.fars
        movea.l far_edges_place+far_place_lines(a2),a0
        addq.l  #far_line_end,a0
        movea.l far_edges_near(a2),a6
        movea.l far_edges_place+far_place_row(a2),a3
        move.l  far_edges_nears(a2),(sp)
        movea.w #far_line_sizeof,a5
.near   move.l  far_edges_place+far_place_pitch(a2),d2
        move.l  edge_lines(a6),d3
        move.l  edge_x(a6),d1
        add.l   a3,d1
        add.l   edge_whole(a6),d2
        move.l  edge_error(a6),d0
        movea.l edge_part(a6),a1
        move.l  edge_height(a6),d4
        subq.w  #1,d3
.step   move.l  d1,(a0)
        adda.l  a5,a0
        add.l   a1,d0
        subx.l  d5,d5                   ; -1 after a carry; X stays
        addx.l  d2,d1
        and.l   d4,d5
        sub.l   d5,d0
        dbra    d3,.step
        subq.l  #1,(sp)
        beq.s   .nears
        move.l  edge_lines(a6),d0
        muls.l  far_edges_place+far_place_pitch(a2),d0
        adda.l  d0,a3
        lea     edge_sizeof(a6),a6
        bra.s   .near
.nears  addq.l  #4,sp
        rts
edges_kept
        return_all
