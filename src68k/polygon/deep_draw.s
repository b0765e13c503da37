        include "routine.i"
        include "deep.i"

        xref    polygon_outline,edges_make,depth_inside,way_inside,edges_far_inside,far_span_inside
        xref    _far_spans,_deep_rest

Q_ONE   equ     1<<30                   ; q of the nearest vertex
STEEP   equ     1<<22                   ; steps from here on are never straight

; d2 = the magnitude of the step \1 of q a pixel, rounded up. Uses d0-d1.
steep   macro
        movem.l perspective_plan_q+screen_plane_\1(a4),d0-d1
        move.l  d0,d2
        bpl.s   .positive\@
        not.l   d2
        tst.l   d1
        bne.s   .positive\@
        addq.l  #1,d2
.positive\@
        addq.l  #1,d2
        endm

; Branches to \3 if lines of \1 pixels on which q grows by d2 a pixel and is \2 or more are bent: d2 (\1^2 / 2 + 1) is
; above \2. Uses d0-d1.
bent    macro
        cmp.l   #STEEP,d2
        bge.s   \3
        move.l  \1,d0
        mulu.w  d0,d0
        lsr.l   #1,d0
        addq.l  #1,d0
        mulu.l  d2,d1:d0
        tst.l   d1
        bne.s   \3
        cmp.l   \2,d0
        bhi.s   \3
        endm

; deep_draw - draws a polygon in perspective by the plan of its material
;
; in:      a0  deep*   the plan; renderer, vertices and count of its setup are set
; out:     d0  int32   enum polygon_result; DEEP_CONSTANT: w is constant, and nothing is drawn
; reads:   the plan, the vertices, the map
; writes:  the plan, scratch memory; pixels
; formats: polygon_outline's, perspective_depth's, far_find's and those of the spans
; error:   theirs
; cost:    about 9,000 cycles for a triangle that is drawn from the far ends of its lines, and these

; Polygons that may be drawn as if their depth were constant along lines or columns, or are not drawn from the far ends
; of their lines, or whose lines are to be cut to the frame, are drawn by deep_rest.

        routine deep_draw,a0
        save_all
        deep_outline -2         ; without a plane or edges: columns need none
        deep_rows
        lea     deep_depth(a6),a5
        jsr     depth_inside
        tst.l   d0
        beq     .unsure
        move.l  setup_sides+sides_x_low(a6),d0
        bmi     .rest
        move.l  setup_sides+sides_x_high(a6),d0
        add.l   #EDGE_ERROR,d0
        cmp.l   deep_right(a6),d0
        bhi     .rest

        ; as perspective_find_level
        movem.l setup_box(a6),d4-d7
        sub.l   d4,d6                   ; width
        sub.l   d5,d7                   ; height
        move.l  perspective_plan_q_low(a4),d3
        move.l  d3,d4
        moveq   #PERSPECTIVE_EVEN_STEEP,d5
        asr.l   d5,d4
        moveq   #LEVEL_NOTHING,d5
        steep   dx
        cmp.l   d4,d2
        ble     .rest                   ; perhaps level
        bent    d6,d3,.lines
        moveq   #PERSPECTIVE_TILT_LEAST,d0
        cmp.l   d0,d6
        bgt     .rest
        moveq   #LEVEL_LINES,d5
        bra.s   .find
.lines  tst.l   deep_exact(a6)
        beq.s   .find
        steep   dy
        move.l  #PERSPECTIVE_COLUMN,d3
        cmp.l   d4,d2
        ble.s   .columns
        bent    d7,#Q_ONE,.find
        move.l  #PERSPECTIVE_COLUMN_TILTED,d3
.columns
        move.w  deep_saved+2(a6),d0
        mulu.w  d7,d0
        move.l  d0,d2
        add.l   d0,d0
        moveq   #3,d1
        cmp.l   setup_count(a6),d1
        beq.s   .halves
        add.l   d2,d0                   ; three quarters of the box
.halves lsr.l   #2,d0
        neg.l   d0
        add.l   d3,d0
        muls.l  d6,d0
        add.l   #PERSPECTIVE_TURN,d0
        move.w  #PERSPECTIVE_LINE,d1
        mulu.w  d7,d1
        cmp.l   d1,d0
        blt     .rest                   ; columns are cheaper
.find   move.l  d5,setup_level(a6)
        lea     deep_way(a6),a0
        jsr     way_inside
        tst.l   d0
        beq     .rest
        tst.l   setup_level(a6)
        beq.s   .far
        tst.l   far_plan_less(a0)
        bne     .rest                   ; straight lines are more accurate

        ; the lines, from edges inside the frame
.far    tst.l   setup_edges+edge_plan_lefts(a6)
        bne.s   .edges
        lea     setup_edges(a6),a0
        lea     setup_sides(a6),a1
        lea     setup_box(a6),a2
        move.l  a2,d0
        move.l  deep_exact(a6),d1
        jsr     edges_make
.edges  lea     -far_edges_sizeof(sp),sp
        movea.l sp,a2
        move.l  setup_scratch(a6),d0
        add.l   #scratch_room,d0
        move.l  d0,far_edges_place+far_place_lines(a2)
        move.l  setup_span+span_plan_row(a6),far_edges_place+far_place_row(a2)
        move.l  setup_span+span_plan_pitch(a6),far_edges_place+far_place_pitch(a2)
        move.l  perspective_plan_q+screen_plane_at(a4),d0
        move.l  perspective_plan_q+screen_plane_dx(a4),d1
        move.l  perspective_plan_q+screen_plane_dy(a4),d2
        tst.l   deep_way+far_way_even(a6)
        beq.s   .once
        add.l   d0,d0
        bchg    #31,d0
        add.l   d1,d1
        add.l   d2,d2
.once   movem.l d1-d2,far_edges_place+far_place_dqdx(a2)        ; and dqdy
        movem.l setup_edges+edge_plan_left(a6),d4-d7    ; right, lefts, rights
        move.l  perspective_plan_left(a4),d3
        add.l   #EDGE_BIAS,d3
        tst.l   d1
        bpl.s   .rightwards
        addq.l  #1,d3
        exg     d4,d5
        exg     d6,d7
.rightwards
        muls.l  d1,d3
        sub.l   d3,d0
        move.l  d0,far_edges_place+far_place_q(a2)
        movem.l d4-d7,far_edges_far(a2) ; near, fars, nears
        movem.l a4/a6,-(sp)
        jsr     edges_far_inside
        movem.l (sp)+,a4/a6
        move.l  far_edges_place+far_place_lines(sp),d7
        lea     far_edges_sizeof-far_span_sizeof(sp),sp

        lea     deep_depth(a6),a5
        lea     deep_way(a6),a3
        movea.l sp,a0
        move.l  d7,far_span_lines(a0)
        jsr     far_span_inside
        lea     _far_spans,a1
        move.l  far_way_even(a3),d0
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0                   ; three for each
        add.l   far_way_coarse(a3),d0
        lea     (a1,d0.l*8),a1
        tst.l   perspective_plan_q+screen_plane_dx(a4)
        bpl.s   .draw
        addq.l  #4,a1
.draw   movea.l (a1),a1
        jsr     SPAN_SAVED(a1)
        lea     far_span_sizeof(sp),sp
        moveq   #POLYGON_DRAWN,d0
.done   return_all
.constant
        moveq   #DEEP_CONSTANT,d0
        bra.s   .done
.unsure moveq   #0,d0
        bra.s   .slow
.rest   moveq   #1,d0
.slow   move.l  d0,-(sp)
        move.l  a6,-(sp)
        jsr     _deep_rest
        addq.l  #8,sp
        bra.s   .done
