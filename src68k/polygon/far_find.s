        include "routine.i"

        xref    asymptotes_inside,constants_inside,_far_lengths

Q_ONE   equ     1<<30                   ; q of the nearest vertex

        ifne    far_way_plan|depth_corners
        fail    a plan is not where its way begins, or corners not where a depth does
        endc

; far_way_to_\1 = d0 = the whole texels from K of \1, u or v, to the farther end of its range, rounded up. d2: the bits
; of K below a texel. Uses d1/d3.
farthest macro
        move.l  far_plan_k\1(a0),d1
        asr.l   d2,d1
        move.w  perspective_plan_\1_high(a4),d0
        ext.l   d0
        sub.l   d1,d0
        move.w  perspective_plan_\1_low(a4),d3
        ext.l   d3
        sub.l   d3,d1
        cmp.l   d1,d0
        bge.s   .above\@
        move.l  d1,d0
.above\@
        addq.l  #1,d0
        move.l  d0,far_way_to_\1(a0)
        endm

; far_find - how a polygon is drawn from the far ends of its lines
;
; in:      a0  far_way*      to fill in
;          a1  const setup*  box, sides, setting and lines of the polygon, and its perspective_plan
;          d0  const depth*  what its planes are found from
; out:     d0  int32         1; 0 if it is not drawn so: too deep, too steep, or K or C do not fit
; reads:   the setup, the planes' q and ranges, the depth
; writes:  the way; if it is not drawn so, a part of it
; formats: far_asymptotes' and far_constants'
; error:   theirs
; cost:    about 2,000 cycles

        routine far_find,a0,a1,d0
        save_all
        movea.l a1,a6
        movea.l d0,a5
        movea.l setup_perspective(a6),a4
        pea     way_kept(pc)
        xdef    way_inside,_way_inside
; As far_find; the way is a0, the setup a6, the depth a5 and the perspective_plan a4. Keeps a0/a4-a6.
_way_inside
way_inside
        ; d7: the least q of a pixel; by rounded edges a pixel may be a step outside the polygon
        tst.l   depth_gentle(a5)
        beq     .not
        movem.l perspective_plan_q+screen_plane_dx(a4),d0-d1
        move.l  d0,d2
        bpl.s   .steep
        not.l   d2
        tst.l   d1
        bne.s   .steep
        addq.l  #1,d2
.steep  addq.l  #1,d2                   ; |dq/dx|, rounded up
        tst.l   d0
        minus   <neg.l d0>
        move.l  setup_box+rectangle_right(a6),d5
        sub.l   setup_box+rectangle_left(a6),d5
        add.l   setup_span+span_plan_count(a6),d5
        movem.l perspective_plan_q_low(a4),d3/d7        ; and q_high
        exg     d3,d7
        sub.l   d5,d7
        movea.l setup_material(a6),a1
        cmp.b   #EDGES_SNAPPED,material_edges(a1)
        bhs.s   .exact
        sub.l   d2,d7
.exact  cmp.l   #1<<(29-FAR_DEEP),d7
        blt     .not
        sub.l   d2,d3
        cmp.l   #Q_ONE,d3
        bgt     .not
        moveq   #FAR_K_SCALE,d3
        cmp.l   depth_scale(a5),d3
        ble     .not
        cmp.l   #FAR_DOWN,depth_down(a5)
        bgt     .not

        lea     _far_lengths,a2
        moveq   #PERSPECTIVE_EVERY16,d3
        cmp.l   setup_setting(a6),d3
        beq.s   .lengths
        lea     far_lengths_sizeof(a2),a2
        cmp.b   #PERSPECTIVE_EVERY8,material_perspective(a1)
        beq.s   .lengths
        lea     far_lengths_sizeof(a2),a2
.lengths
        move.l  a2,far_way_lengths(a0)

        ; d1: the bits by which q has to be shifted left; d6: 1 for even spans
        cmp.l   #1<<FAR_EVEN,d7
        blt.s   .uneven
        add.l   d0,d0
        moveq   #1,d1
        moveq   #1,d6
        cmp.l   far_lengths_most_4(a2),d0
        bls.s   .even
.uneven bfffo   d7{0:32},d1
        subq.l  #1,d1
        moveq   #-2,d6
        and.l   d6,d1
        move.l  #FAR_MOST,d4
        lsr.l   d1,d4
        cmp.l   d4,d2
        bgt     .not
        moveq   #0,d6
.even   movem.l d1/d6,far_way_shift(a0)
        add.l   depth_off(a5),d5
        moveq   #FAR_OFF_CORNERS,d4
        add.l   d4,d5
        lsl.l   d1,d5
        moveq   #11,d4
        asr.l   d4,d5
        moveq   #FAR_OFF_PART,d4
        add.l   d4,d5
        move.l  d5,far_way_part(a0)

        ; K; d4: the texels to it, 0 if it cannot be told
        move.l  a5,far_plan_corners(a0)
        move.l  depth_scale(a5),far_plan_scale(a0)
        clr.l   far_plan_less(a0)
.reach  jsr     asymptotes_inside
        moveq   #0,d4
        tst.l   d0
        beq.s   .told
        moveq   #16+FAR_K_BITS,d2
        sub.l   far_plan_less(a0),d2
        farthest u
        move.l  d0,d4
        farthest v
        cmp.l   d4,d0
        ble.s   .told
        move.l  d0,d4
.told   tst.l   far_plan_less(a0)
        bne.s   .coarser
        tst.l   d4
        beq.s   .less
        moveq   #0,d1
        moveq   #FAR_BITS,d0
        cmp.l   #FAR_REACH,d4
        ble.s   .near
        moveq   #1,d1
        moveq   #FAR_BITS_COARSE,d0
        cmp.l   #FAR_REACH<<FAR_COARSE,d4
        ble.s   .near
.less   moveq   #FAR_COARSE,d0
        move.l  d0,far_plan_less(a0)
        bra     .reach
.coarser
        tst.l   d4
        beq     .not
        cmp.l   #FAR_REACH<<(2*FAR_COARSE),d4
        bgt     .not
        move.l  perspective_plan_q+screen_plane_dx(a4),d0
        minus   <neg.l d0>
        move.l  far_way_part(a0),d1
        moveq   #14,d2
        lsl.l   d2,d1
        cmp.l   d1,d0
        blo     .not
        moveq   #2,d1
        moveq   #FAR_BITS_COARSE,d0
.near   move.l  d1,far_way_coarse(a0)

        ; C, from u and v of the top and the bottom
        lea     plane_corners_b(a5),a1
        tst.b   setup_sides+sides_middle_right(a6)
        bne.s   .right
        lea     plane_corners_a(a5),a1
.right  move.l  a1,far_plan_bottom(a0)
        movem.l setup_sides+sides_top(a6),a1-a2         ; and bottom
        movem.l vertex_s(a1),d2-d3
        movem.l vertex_s(a2),d4-d5
        move.l  perspective_plan_u(a4),d6
        move.l  perspective_plan_v(a4),d7
        subq.l  #1,d6
        subq.l  #1,d7
        sub.l   d6,d2
        sub.l   d7,d3
        sub.l   d6,d4
        sub.l   d7,d5
        tst.l   far_plan_less(a0)
        bne.s   .cut
        lsl.l   #FAR_K_BITS,d2
        lsl.l   #FAR_K_BITS,d3
        lsl.l   #FAR_K_BITS,d4
        lsl.l   #FAR_K_BITS,d5
        bra.s   .texels
.cut    asr.l   #FAR_COARSE-FAR_K_BITS,d2
        asr.l   #FAR_COARSE-FAR_K_BITS,d3
        asr.l   #FAR_COARSE-FAR_K_BITS,d4
        asr.l   #FAR_COARSE-FAR_K_BITS,d5
.texels movem.l d2-d5,far_plan_top_u(a0)
        jsr     constants_inside
        rts
.not    moveq   #0,d0
        rts
way_kept
        return_all
