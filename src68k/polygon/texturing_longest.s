        include "nearest.i"

        xref    texturing_wrap

; \2 = what field \1 of the middle vertex a3 has more than the longest scanline's other end, on the
; edge from a1 down to a2, d5 / 2^31 of it below a1. Uses d0-d1.
across  macro
        move.l  \1(a2),d0
        sub.l   \1(a1),d0
        muls.l  d5,d1:d0
        add.l   d0,d0
        addx.l  d1,d1
        add.l   d0,d0
        addx.l  d6,d1
        move.l  \1(a3),\2
        sub.l   \1(a1),\2
        sub.l   d1,\2
        endm

; Puts the step \1 = \1 / d4, 16.16, into the field \2; d4 is above 0, d6 and d7 are as nearest
; needs them. It saturates. Uses d0-d1.
step    macro
        move.l  \1,d0
        minus   <neg.l d0>
        moveq   #15,d1
        lsr.l   d1,d0
        cmp.l   d4,d0
        bhs.s   .steep\@
        move.l  \1,d1
        swap    d1
        move.l  d1,d0
        ext.l   d1
        clr.w   d0                      ; d1:d0 = \1 << 16
        nearest d1,d0
        bra.s   .found\@
.steep\@
        move.l  #$7fffffff,d0
        tst.l   \1
        minus   <neg.l d0>
.found\@
        move.l  d0,texturing_\2(a0)
        endm

; Rounds the step in the field \1 to the nearest multiple of 1 << the field \2. Uses d0-d2.
cut     macro
        move.l  texturing_\2(a0),d1
        beq.s   .whole\@
        moveq   #1,d0
        lsl.l   d1,d0
        lsr.l   #1,d0
        add.l   texturing_\1(a0),d0
        lsr.l   d1,d0
        lsl.l   d1,d0
        move.l  d0,texturing_\1(a0)
.whole\@
        endm

; texturing_longest - a triangle's steps from its longest scanline, the one through the middle vertex
;
; in:      a0  texturing*  to fill in; its cuts are set: 0 to 8, 0 for a chain
;          a1  sides*      the triangle, its area not 0
;          d0  rectangle*  the pixels that it may cover
;          d1  int32       enum chain
; reads:   u_cut, v_cut; *sides, its vertices, the rectangle
; writes:  dudx, dvdx, wraps, wrap_bit; u_cut if the chain needs a bit
; formats: 16.16; with x', s' = those of the long edge on the middle's line, to the nearest unit, its
;          part above this line being the nearest multiple of 2^-31, below 1: dudx = (s - s') /
;          (x - x') to the nearest unit and then to a multiple of 1 << cut units; at most 32,768
;          texels, and 0 where x = x'
; error:   of x and s: h, half a unit and 1 in 2^32 of the edge's width or rise, which is another half at
;          most; (1 + |g|) h / (width - h) of a gradient g
; cost:    about 600 cycles with a cold cache
        routine texturing_longest,a0,a1,d0,d1
        movem.l d2-d7/a2-a3,-(sp)
        jsr     longest_find
        movem.l (sp)+,d2-d7/a2-a3
        rts

; longest_find - the same for assembly
;
; like:    texturing_longest
; trashes: d0-d7/a1-a3
; cost:    80 cycles less than texturing_longest
        routine longest_find
        move.l  d0,-(sp)
        move.l  d1,-(sp)
        movea.l sides_middle(a1),a3
        movem.l sides_top(a1),a1-a2     ; and bottom
        moveq   #0,d6
        move.l  vertex_y(a1),d0
        move.l  vertex_y(a2),d4
        sub.l   d0,d4
        move.l  d4,d7
        lsr.l   #1,d7
        move.l  vertex_y(a3),d1
        sub.l   d0,d1
        moveq   #0,d0
        lsr.l   #1,d1
        roxr.l  #1,d0
        add.l   d7,d0                   ; no carry: 0 or 2^31, and less than 2^31
        divu.l  d4,d1:d0
        move.l  d0,d5
        minus   <subq.l #1,d5>
        across  vertex_s,d2
        across  vertex_t,d3
        across  vertex_x,d4             ; width
        tst.l   d4
        bgt.s   .right
        beq     .narrow
        neg.l   d4
        neg.l   d2
        neg.l   d3
.right  move.l  d4,d7
        lsr.l   #1,d7
        step    d2,dudx
        step    d3,dvdx
.wrap   movem.l (sp)+,d0/a1
        jsr     texturing_wrap
        cut     dudx,u_cut
        cut     dvdx,v_cut
        rts
.narrow clr.l   texturing_dudx(a0)
        clr.l   texturing_dvdx(a0)
        bra     .wrap
