        include "routine.i"

        ifne    far_way_plan
        fail    a plan is not where its way begins
        endc

; far_span_find - the span of a polygon that is drawn from the far ends of its lines, but for these
;
; in:      a0  far_span*       to fill in
;          a1  const setup*    the polygon, its perspective_plan and its renderer
;          d0  const depth*    what its planes are found from
;          d1  const far_way*  how it is drawn
; reads:   q, u, v, q_low of the perspective_plan; down of the depth; the way; the renderer's reciprocals
; writes:  the span but lines; from_8, from_16 and ends only of even ones
; formats: struct far_span's. From the index from_8 on q / dq is 8 squared times 2^19 / FAR_EVERY16's power of two or
;          more, from_16 so for 16. `ends` is on by FAR_AHEAD16 or FAR_AHEAD8 eighths of the most that a chord of the
;          polygon is off: 16^2 dq / (4 q_low) if all pieces have 16 pixels
; error:   K is raised by what FAR_OFF, FAR_OFF_WORD, FAR_OFF_LINES and the way's part say, so that lines are never low
; cost:    700 to 850 cycles on a1200-fast, the call included
        routine far_span_find,a0,a1,d0,d1
        save_all
        movea.l a1,a6
        movea.l d0,a5
        movea.l d1,a3
        movea.l setup_perspective(a6),a4
        pea     span_kept(pc)
        xdef    far_span_inside,_far_span_inside
; As far_span_find; the setup is a6, the depth a5, the way a3 and the perspective_plan a4. Keeps a0/a3-a6.
_far_span_inside
far_span_inside
        move.l  setup_span+span_plan_count(a6),far_span_count(a0)
        move.l  setup_span+span_plan_map(a6),far_span_map(a0)
        movea.l setup_renderer(a6),a1
        movea.l renderer_reciprocals(a1),a1
        move.l  a1,far_span_table(a0)
        move.l  perspective_plan_q+screen_plane_dx(a4),d0
        minus   <neg.l d0>
        move.l  d0,far_span_dq(a0)
        movea.l far_way_lengths(a3),a2
        move.l  a2,far_span_lengths(a0)
        tst.l   far_way_even(a3)
        beq     .k

        add.l   d0,d0                   ; 2 dq, at most 2^27
        move.l  #(1<<(FAR_EVERY16-21))-1,d1
        moveq   #FAR_EVERY16-21,d5
        moveq   #PERSPECTIVE_EVERY16,d2
        cmp.l   setup_setting(a6),d2
        beq.s   .every
        lsr.l   #1,d1
        subq.w  #1,d5
.every  add.l   d0,d1
        lsr.l   d5,d1                   ; the index from which pieces have 16 pixels
        move.l  d1,d2
        addq.l  #3,d2
        lsr.l   #2,d2                   ; and 8
        sub.w   #FAR_ORIGIN,d2
        move.w  d2,far_span_from_8(a0)
        sub.l   #FAR_ORIGIN,d1
        cmp.l   #FAR_NEVER,d1
        blt.s   .index
        move.l  #FAR_NEVER,d1
.index
        tst.l   (a2)                    ; most_16; 0 if a tolerance allows 8 pixels
        beq.s   .never
        move.w  d1,far_span_from_16(a0)
        move.l  perspective_plan_q_low(a4),d2
        move.l  d2,d3
        moveq   #15,d4
        asr.l   d4,d3
        sub.l   #FAR_ORIGIN,d3
        cmp.w   d3,d1
        bgt.s   .some
        moveq   #10,d4
        lsr.l   d4,d0                   ; dq / 2^9, below 2^16
        mulu.w  d0,d0
        cmp.w   #FAR_EVERY16-21,d5
        bne.s   .eighths
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        lsr.l   #2,d0                   ; times FAR_AHEAD16 / 4
.eighths
        lsr.l   #8,d2
        divu.l  d2,d0
        bra.s   .ahead
.some   move.l  d0,d1
        cmp.w   #FAR_EVERY16-21,d5
        beq.s   .some_16
        add.l   d0,d0                   ; times FAR_AHEAD8 / 2
        moveq   #FAR_EVERY16+18-FAR_EVERY8,d4
        lsr.l   d4,d0
        bra.s   .ahead
.some_16
        lsr.l   #1,d1
        add.l   d1,d0                   ; times FAR_AHEAD16 / 2
        moveq   #18,d4
        lsr.l   d4,d0
.ahead  lea     (a1,d0.l*2),a1
        bra.s   .ends
.never  move.w  #FAR_NEVER,far_span_from_16(a0)
.ends   move.l  a1,far_span_ends(a0)

        ; d3: units by which K is raised
.k      move.l  far_way_shift(a3),d1
        moveq   #1,d3
        lsl.l   d1,d3
        move.l  depth_down(a5),d2
        addq.l  #FAR_OFF_LINES,d2
        lsl.l   d1,d2
        move.l  far_plan_less(a3),d1
        lsl.l   d1,d3
        addq.l  #FAR_OFF,d3
        tst.l   far_way_coarse(a3)
        beq.s   .words
        lsr.l   #1,d2
        lsl.l   d1,d2
        bra.s   .raise
.words  lsr.l   #5,d2
        add.l   #FAR_OFF_WORD,d2
.raise  add.l   d2,d3
        addq.l  #8-FAR_K_BITS,d1
        move.l  far_way_part(a3),d2
        movem.l far_way_to_u(a3),d4-d5  ; and to_v
        muls.l  d2,d4
        muls.l  d2,d5
        asr.l   #2,d4
        asr.l   #2,d5
        add.l   d3,d4
        add.l   d3,d5
        add.l   perspective_plan_u(a4),d4
        add.l   perspective_plan_v(a4),d5
        lsl.l   #8,d4
        lsl.l   #8,d5
        movem.l far_plan_ku(a3),d2-d3   ; and kv
        lsl.l   d1,d2
        lsl.l   d1,d3
        add.l   d2,d4
        add.l   d3,d5
        movem.l far_plan_cu(a3),d0-d3   ; cv, dcu, dcv
        movem.l d0-d1,far_span_cu(a0)   ; and cv
        movem.l d2-d3,far_span_dcu(a0)
        movem.l d4-d5,far_span_ku(a0)
        rts

span_kept
        return_all
