        include "deep.i"

        xref    polygon_outline,lines_flat,lines_flat_exact,scissor_flat,coverage_scan,depth_inside
        xref    _cover_rest

; cover_draw - draws what is visible of a polygon in perspective by the plan of its material, and covers it
;
; in:      a0  deep*   the plan; renderer, vertices and count of its setup are set
; out:     d0  int32   enum polygon_result; DEEP_CONSTANT: w is constant, and nothing is drawn or covered
; reads:   the plan, the vertices, the map, the gaps of lines
; writes:  the plan, scratch memory, the renderer's coverage; pixels
; formats: polygon_outline's, coverage_scan's, perspective_depth's and those of the spans
; error:   theirs
; cost:    about 5,000 cycles for four vertices, and those of coverage_scan, before cover_rest

        routine cover_draw,a0
        save_all
        deep_outline -1         ; without a plane
        deep_rows

        ; the table of lines, cut to the frame
        lea     lines_flat_exact,a1
        tst.l   deep_exact(a6)
        bne.s   .lines
        lea     lines_flat,a1
.lines  lea     setup_edges(a6),a0
        move.l  a6,-(sp)
        jsr     (a1)
        movea.l (sp)+,a6
        movea.l setup_frame(a6),a1
        move.l  frame_width(a1),d2
        tst.l   setup_sides+sides_x_low(a6)
        bmi.s   .beyond
        move.l  setup_sides+sides_x_high(a6),d0
        add.l   #EDGE_ERROR,d0
        move.l  d2,d1
        swap    d1
        cmp.l   d1,d0
        ble.s   .inside
.beyond lea     -scissor_plan_sizeof(sp),sp
        movea.l sp,a0
        move.l  setup_edges+edge_plan_lines(a6),scissor_plan_lines(a0)
        move.l  setup_span+span_plan_count(a6),scissor_plan_count(a0)
        move.l  d2,scissor_plan_width(a0)
        jsr     scissor_flat
        lea     scissor_plan_sizeof(sp),sp

.inside lea     -scan_plan_sizeof(sp),sp
        movea.l sp,a0
        movea.l setup_renderer(a6),a1
        movea.l renderer_coverage(a1),a2
        move.l  setup_edges+edge_plan_lines(a6),scan_plan_lines(a0)
        move.l  setup_span+span_plan_count(a6),scan_plan_count(a0)
        move.l  setup_box+rectangle_top(a6),d0
        movea.l coverage_rows(a2),a1
        lea     (a1,d0.l*4),a1
        move.l  a1,scan_plan_rows(a0)
        move.l  a2,scan_plan_coverage(a0)
        moveq   #COVER_DIRECT,d0
        move.l  d0,coverage_way(a2)
        jsr     coverage_scan
        lea     scan_plan_sizeof(sp),sp
        tst.l   coverage_overflow(a2)
        bne.s   .drawn
        tst.l   coverage_seen(a2)
        beq.s   .drawn
        moveq   #1,d0
        move.l  d0,coverage_shown(a2)
        lea     deep_depth(a6),a5
        jsr     depth_inside
        move.l  d0,-(sp)
        move.l  a6,-(sp)
        jsr     _cover_rest
        addq.l  #8,sp
        bra.s   .done
.drawn  moveq   #POLYGON_DRAWN,d0
.done   return_all
.constant
        moveq   #DEEP_CONSTANT,d0
        bra.s   .done
