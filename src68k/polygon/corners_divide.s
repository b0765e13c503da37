        include "routine.i"

; corners_divide - W, S and T of three corners, from their s, t and w
;
; in:      a0  vertex*  the three, whose s, t and w become S, T and W
;          a1  planes_division*  how they are scaled
; reads:   s, t and w of the corners; the division
; writes:  s, t and w of the corners
; formats: W = floor((nearest * least + floor(|w| / 2)) / |w|), with the sign of w; S = floor((s * 2^bits * W +
;          floor(one / 2)) / one), T as S: to the nearest, halves up; s * 2^bits modulo 2^32
; error:   half a unit each; the quotients must fit 32 bits
; cost:    about 800 cycles where `one` is 2^30, 1,000 otherwise
        routine corners_divide,a0,a1
        save_all
        movem.l planes_division_least(a1),d4-d7 ; nearest, one, bits
        mulu.l  d5,d5:d4                ; nearest * least
        movea.l d4,a2
        movea.l d5,a3
        moveq   #2,d4
        swap    d4
        move.w  d7,d4                   ; corners left : bits
        move.l  d6,d7
        lsr.l   #1,d7
        suba.l  a4,a4                   ; 1: one is not 2^30
        cmp.l   #1<<30,d6
        beq.s   .corner
        addq.l  #1,a4
.corner move.l  vertex_w(a0),d5
        move.l  d5,d3
        minus   <neg.l d3>
        move.l  d3,d0
        lsr.l   #1,d0
        move.l  a3,d1
        add.l   a2,d0
        bcc.s   .nearest
        addq.l  #1,d1
.nearest
        divu.l  d3,d1:d0
        tst.l   d5
        minus   <neg.l d0>
        move.l  d0,vertex_w(a0)
        move.l  d0,d5
        movem.l vertex_s(a0),d0/d2
        lsl.l   d4,d0
        lsl.l   d4,d2
        muls.l  d5,d1:d0
        muls.l  d5,d3:d2
        add.l   d7,d0
        bcc.s   .first
        addq.l  #1,d1
.first  add.l   d7,d2
        bcc.s   .second
        addq.l  #1,d3
.second move.l  a4,d5
        bne.s   .odd
        moveq   #3,d5
        rol.l   #2,d0
        lsl.l   #2,d1
        and.l   d5,d0
        or.l    d1,d0
        rol.l   #2,d2
        lsl.l   #2,d3
        and.l   d5,d2
        or.l    d3,d2
.next   movem.l d0/d2,vertex_s(a0)
        lea     vertex_sizeof(a0),a0
        sub.l   #1<<16,d4
        bpl     .corner
        return_all
.odd    divs.l  d6,d1:d0                ; towards zero
        tst.l   d1
        minus   <subq.l #1,d0>
        divs.l  d6,d3:d2
        tst.l   d3
        minus   <subq.l #1,d2>
        bra     .next
