        include "routine.i"

; n64_quads - makes the quads of the filters from texels and their neighbours
;
; in:      a0  const uint32*  a row's texels, R G B A
;          a1  struct n64_quad*  quads
;          a2  const n64_quad_row*  the row below, and the step to the next texel
; reads:   count + 1 texels of both rows, each a step from the one before
; writes:  the quads, each a step from the one before, except their unused fields
; formats: channels of quads 8.8

; Two channels at a time, each times 8: 0cc0 0cc0. A quad's right texels are the next quad's
; left ones.

; d0, d1 = two channels of the texels in them. \1: the shift that moves these to their places.
quad_channels macro
        \1,d0
        \1,d1
        and.l   d7,d0
        and.l   d7,d1
        endm

; Writes half of a quad. In: d0, d1 the channels on the right; \1, \2 those on the left, which are
; replaced by the right ones; \3: rb or ga.
quad_half macro
        move.l  d0,d2
        sub.l   \1,d2
        move.l  d2,n64_quad_lower+n64_triangle_\3_s(a1)
        move.l  \2,d2
        sub.l   \1,d2
        move.l  d2,n64_quad_lower+n64_triangle_\3_t(a1)
        move.l  \2,d2
        sub.l   d1,d2
        move.l  d2,n64_quad_upper+n64_triangle_\3_s(a1)
        move.l  d0,d2
        sub.l   d1,d2
        move.l  d2,n64_quad_upper+n64_triangle_\3_t(a1)
        move.l  \1,d2
        lsl.l   #5,d2
        add.l   d6,d2
        move.l  d2,n64_quad_lower+n64_triangle_\3(a1)
        move.l  d1,d2
        lsl.l   #5,d2
        add.l   d6,d2
        move.l  d2,n64_quad_upper+n64_triangle_\3(a1)
        adda.l  \2,\1
        movea.l d1,\2
        add.l   d0,d1
        add.l   \1,d1
        lsl.l   #3,d1
        add.l   d6,d1
        move.l  d1,n64_quad_mean_\3(a1)
        movea.l d0,\1
        endm

        pass    n64_quads
        save_all
        move.l  d0,d5                   ; count
        move.l  n64_quad_row_step(a2),d3
        movea.l n64_quad_row_below(a2),a2
        lsl.l   #2,d3                   ; bytes to the next texel,
        move.l  d3,d4
        lsl.l   #4,d4                   ; the next quad
        move.l  #$00800080,d6           ; 8 * 16
        move.l  #$07f807f8,d7
        move.l  (a0),d0
        move.l  (a2),d1
        quad_channels <lsr.l #5>
        movea.l d0,a3
        movea.l d1,a4
        move.l  (a0),d0
        move.l  (a2),d1
        quad_channels <lsl.l #3>
        movea.l d0,a5
        movea.l d1,a6
.quads  adda.l  d3,a0
        adda.l  d3,a2
        move.l  (a0),d0
        move.l  (a2),d1
        quad_channels <lsr.l #5>
        quad_half a3,a4,rb
        move.l  (a0),d0
        move.l  (a2),d1
        quad_channels <lsl.l #3>
        quad_half a5,a6,ga
        adda.l  d4,a1
        subq.l  #1,d5
        bne     .quads
        return_all
