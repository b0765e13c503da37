; Triangles of a batch that are set up in 32 bits: what the loops of all mappers share.
;
; A vertex is a struct snapped_vertex. Its first longword is x + 1 pixel and y + 15/16 pixel, 12.4
; each, so that x:y of two vertices are subtracted at once, y >> 4 is the first line at or below
; the vertex, and ~y & 15 are the sixteenths of a line from the vertex down to there.
;
; The long edge goes from the top vertex to the bottom one, the two short ones by the middle vertex.
; Values are interpolated along the long edge; a line is drawn away from it, to the right if it is
; the left one, else to the left. In names, l is the long edge's side and r the other one.
;
; Slopes are products with a table of reciprocals (c/triangle/tables.c): 2^31 / dy below
; FINER_HEIGHT sixteenths of a line, 2^39 / dy from there on.

        include "routine.i"

; What the set-up reads, at a5: above a triangle's own values on the stack.
                rsreset
batch_cull      rs.l    1
batch_end       rs.l    1               ; of the list
batch_row       rs.l    1               ; row 0 of the frame
batch_source    rs.l    1               ; the map, or the colour
batch_reciprocals rs.l  1
batch_pitch     rs.l    1
batch_room      rs.l    1               ; of a triangle that is not small: below 0 if wide or tall
; tables of lines:
batch_pixels    rs.l    1               ; the frame's row 0, as spans take it
batch_shade     rs.l    1               ; the shade plan
batch_level     rs.l    1               ; the level's difference along the long edge
batch_light     rs.l    1               ; its step a pixel
batch_sizeof    rs.l    0

; Begins a routine that draws the batch a0. \1: the plan's field of what it draws, if any.
triangles_open macro
        save_all
        lea     -batch_sizeof(sp),sp
        movea.l sp,a5
        move.l  triangle_plan_cull(a0),batch_cull(a5)
        move.l  triangle_plan_end(a0),batch_end(a5)
        move.l  triangle_plan_row(a0),batch_row(a5)
        ifnb    \1
        move.l  triangle_plan_\1(a0),batch_source(a5)
        endc
        move.l  triangle_plan_reciprocals(a0),batch_reciprocals(a5)
        move.l  triangle_plan_pitch(a0),batch_pitch(a5)
        movea.l triangle_plan_list(a0),a0
        bra     triangle_next
        endm

; Ends it. a0: the first triangle that was not drawn.
triangles_close macro
        move.l  a0,d0                   ; where GCC expects a pointer, a0 is too
        lea     batch_sizeof(sp),sp
        return_all
        endm

; Reads the next triangle of the list a0 and turns it: a1 top vertex, d0 its x:y, a2 and a3 the next
; two in order, d1 and d2 their x:y less the top's, d6 twice the area in 1/256 square pixel, above
; 0. d5 = 15. Leaves the routine at the list's end and at a triangle with a vertex out of range. A
; triangle without area is left out; one seen from the back is left out or turned round.
triangle_fetch macro
triangle_handed
        lea     -12(a0),a0
triangle_done
        triangles_close
triangle_back
        tst.l   d6
        beq.s   triangle_next
        tst.l   batch_cull(a5)
        bne.s   triangle_next
        exg     d1,d2
        exg     a2,a3
        neg.l   d6
        bra.s   triangle_turned
triangle_next
        cmpa.l  batch_end(a5),a0
        bhs.s   triangle_done
        movem.l (a0)+,a1-a3
        move.l  (a1),d0
        move.l  d0,d6
        move.l  (a2),d1
        or.l    d1,d6
        move.l  (a3),d2
        or.l    d2,d6
        bmi.s   triangle_handed
        cmp.w   d1,d0
        bgt.s   .not_first
        cmp.w   d2,d0
        ble.s   .first
.last   exg     a1,a3                   ; the last is the top
        exg     a2,a3
        exg     d0,d2
        exg     d1,d2
        bra.s   .first
.not_first
        cmp.w   d2,d1
        bgt.s   .last
        exg     a1,a2
        exg     a2,a3
        exg     d0,d1
        exg     d1,d2
.first  sub.l   d0,d1
        sub.l   d0,d2
        move.l  d1,d6
        swap    d6
        muls.w  d2,d6
        move.l  d2,d7
        swap    d7
        muls.w  d1,d7
        sub.l   d7,d6
        ble.s   triangle_back
triangle_turned
        moveq   #15,d5
        endm

; Goes to \1 if the long edge is on the right. Otherwise a2 is the middle vertex and a3 the bottom
; one; there they, and d1 and d2, are still to be exchanged.
triangle_order macro
        cmp.w   d1,d2
        blt     \1
        endm

; Goes to \1 unless the triangle is small: SMALL_HEIGHT sixteenths of a line high and \2 * 16 pixels
; wide at most. Uses d7.
triangle_small macro
        cmp.w   #SMALL_HEIGHT,d2
        bgt     \1
        moveq   #0,d7
        move.w  d2,d7
        lsl.l   #8,d7
        ifeq    \2-2
        add.l   d7,d7
        endc
        cmp.l   d7,d6
        bgt     \1
        endm

; d3 = the first line, d7 = the middle vertex's, d4 = the one below the last. Goes to \1 if there is
; no line.
triangle_lines macro
        bfextu  d0{16:12},d3
        move.w  d0,d4
        add.w   d2,d4
        bfextu  d4{16:12},d4
        cmp.w   d3,d4
        beq     \1
        move.w  d0,d7
        add.w   d1,d7
        bfextu  d7{16:12},d7
        endm

; d4 = the step a pixel away from the long edge of the value at \1 in a vertex, 16.16, towards zero;
; \2 = its difference along that edge. d1 and d3: dy of the middle and of the bottom vertex, d6
; twice the area. \3: the routine that divides where the quotient may not fit, if it may. Uses
; d0/d5/d7.
gradient macro
        move.l  \1(a1),d0
        move.l  \1(a2),d4
        sub.l   d0,d4
        move.l  \1(a3),d7
        sub.l   d0,d7
        movea.l d7,\2
        muls.l  d3,d5:d4
        muls.l  d1,d0:d7
        sub.l   d7,d4
        subx.l  d0,d5
        ifb     \3
        divs.l  d6,d5:d4
        else
        bsr     \3
        endc
        endm

; d4 = d5:d4 / d6 towards zero; 0 where it does not fit. Uses d0/d5.
triangle_quotient macro
        move.l  d5,d0
        bpl.s   .positive
        not.l   d0
.positive
        add.l   d0,d0
        cmp.l   d6,d0
        bhs.s   .wide
        divs.l  d6,d5:d4
        rts
.wide   moveq   #0,d4
        rts
        endm

; The gradients of u and v: a4 and a2 = the steps a pixel, a6 and a3 = their differences along the long
; edge. d3 = dy2 and d1 = dy1 as longwords. \1: the area up to which a quotient may not fit; \2: names
; what texel_slivers \2 adds for those.
texel_gradients macro
        move.l  a6,d6
        move.w  d2,d3
        ext.l   d3
        ext.l   d1
        cmp.l   #\1,d6
        bls     .sliver_\2
        gradient snapped_vertex_u,a6
        movea.l d4,a4
        gradient snapped_vertex_v,a3
.found_\2
        movea.l d4,a2
        endm

; Outside the way of other triangles. texel_quotient, which is triangle_quotient, divides.
texel_slivers macro
.sliver_\1
        gradient snapped_vertex_u,a6,texel_quotient
        movea.l d4,a4
        gradient snapped_vertex_v,a3,texel_quotient
        bra     .found_\1
        endm

; Packs u (\1) and v (\2), 16.16, into \1 = B, uuVv, and \3 = A, v--U. Uses \2.
pack_apart macro
        moveq   #0,\3
        move.b  \2,\3
        ror.l   #8,\3
        swap    \1
        move.b  \1,\3
        lsr.l   #8,\2
        move.w  \2,\1
        endm

; The same for steps: where v falls, every addition of its 24 bits carries into u, so u's step is
; one less.
pack_step_apart macro
        tst.l   \2
        minus   <subq.l #1,\1>
        pack_apart \1,\2,\3
        endm

; Both with A in \2. Use \3.
pack_pair macro
        pack_apart \1,\2,\3
        move.l  \3,\2
        endm

pack_step macro
        pack_step_apart \1,\2,\3
        move.l  \3,\2
        endm

; The value at \1 in a vertex, at the first pixel: \3 (an address register), and d7 = its step a line
; from first pixel to first pixel, or one pixel less. d7 is its step a line along the long edge, \2 its
; step a pixel; d3, d5 and d6 as the long edge leaves them. \4: a register that is added to the start, in
; 1/2^20, if any. Uses d0/d2.
value_first macro
        move.l  d3,d2
        muls.l  d7,d2
        add.l   \1(a1),d2
        ifnb    \4
        add.l   \4,d2
        endc
        asr.l   #4,d2
        movea.l d2,\3
        move.l  \2,d0
        muls.l  d5,d2:d0
        add.l   d0,d0
        addx.l  d2,d2
        sub.l   d2,d7
        move.l  \2,d0
        muls.l  d6,d2:d0
        move.w  d2,d0
        swap    d0
        adda.l  d0,\3
        endm
