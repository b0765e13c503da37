        include "routine.i"

; A line's q and pixels. \1: right if it is drawn from its first pixel, or left.
line    macro
.\1     move.l  (a0)+,d1                ; start0:left
        ext.l   d1
        move.w  (a0)+,d0                ; last
        ext.l   d0
        addq.l  #6,a0
        addq.l  #1,d0
        ifc     '\1','right'
        exg     d0,d1
        endc
        move.l  d0,d2
        muls.l  d5,d2
        add.l   d4,d2
        add.l   d3,d0
        add.l   d3,d1
        move.l  d2,(a1)+
        move.l  d0,(a1)+
        move.l  d1,(a1)+
        add.l   a3,d3
        add.l   a4,d4
        subq.l  #1,d7
        bne.s   .\1
        return_all
        endm

; lines_far - lines of a scanline table, for spans that begin at the far end
;
; in:      a0  far_lines*  the table, what q is
; reads:   left and last of the table's lines
; writes:  the place's lines
; formats: x with EDGE_BIAS, 0 to 32,767; q modulo 2^32
        routine lines_far,a0
        save_all
        movea.l far_lines_place+far_place_lines(a0),a1
        move.l  far_lines_place+far_place_row(a0),d3
        movea.l far_lines_place+far_place_pitch(a0),a3
        move.l  far_lines_place+far_place_q(a0),d4
        move.l  far_lines_place+far_place_dqdx(a0),d5
        movea.l far_lines_place+far_place_dqdy(a0),a4
        move.l  far_lines_count(a0),d7
        tst.l   far_lines_leftwards(a0)
        movea.l far_lines_from(a0),a0
        bne.s   .left
        line    right
        line    left
