        include "eye.i"

; mesh_near - the next node of a tree that has faces, the nearest first as seen from the eye
;
; in:      a0  struct near_walk*  a walk that has begun: node is the root, last is steps
; out:     d0  const struct scene_node*  a node with slots; 0: there is none left
; reads:   the plan, its view's eye, the tree's nodes, their boxes; whatever is_hidden reads
; writes:  node, last, steps
; formats: as in mesh_walk
; error:   mesh_walk's. Nodes whose box is outside a border are left out, with those of their front and back
; cost:    bench row mesh_near: a node that divides others

; Adds the product of a coordinate of the box a3 and its factor, at a1, to d3, or sets it. Uses d0.
along   macro
        move.w  (a1)+,d0
        move.w  (a3,d0.w),d0
        muls.w  (a1)+,d0
        \1.l    d0,d3
        endm

; a0 the node, a1 the border, a2 behind the last step, a3 the box, a4 the plan, a5 the farther half space's first
; node, a6 not 0: the node is the first of such a half space; d5-d7 the eye.
        routine mesh_near,a0
        save_all
        movea.l a0,a4
        movea.l near_walk_view(a4),a1
        movem.l scene_view_eye_x(a1),d5-d7
        movea.l near_walk_last(a4),a2
        movea.w #1,a6
        move.l  near_walk_node(a4),d0
        bne.s   .enter
.step   cmpa.l  near_walk_steps(a4),a2
        beq     .end
        movea.l -(a2),a5
        movea.l -(a2),a0
        tst.l   scene_node_slots(a0)
        bne     .found
        movea.w #1,a6
        move.l  a5,d0
        beq.s   .step
.enter  movea.l d0,a0
        sub.l   near_walk_nodes(a4),d0
        lsr.l   #1,d0                   ; scene_node_sizeof / mesh_box_sizeof
        movea.l near_walk_boxes(a4),a3
        adda.l  d0,a3
        lea     near_walk_borders(a4),a1
        moveq   #NEAR_BORDERS-1,d4
.border along   move
        along   add
        along   add
        cmp.l   (a1)+,d3
        blt.s   .step
        dbra    d4,.border
        move.l  a6,d0
        bne     .test
.seen   move.l  scene_node_front(a0),d0
        or.l    scene_node_back(a0),d0
        beq     .last
        eye_along a0,scene_node
        lea     scene_node_sizeof(a0),a5
        move.l  scene_node_front(a0),d0
        move.l  d0,d3
        lsl.l   #5,d3                   ; scene_node_sizeof
        lea     (a5,d3.l),a3
        tst.l   d0
        bne.s   .front
        suba.l  a5,a5
.front  tst.l   scene_node_back(a0)
        bne.s   .back
        suba.l  a3,a3
.back   cmp.l   scene_node_distance(a0),d2
        blt.s   .behind
        exg     a3,a5
.behind move.l  a0,(a2)+
        move.l  a5,(a2)+
        suba.l  a6,a6
        move.l  a3,d0
        bne     .enter
        bra     .step

.test   cmp.w   #NEAR_TESTED,mesh_box_slots(a3)
        blo     .seen
        move.l  near_walk_is_hidden(a4),d0
        beq     .seen
        movea.l d0,a1
        move.l  a0,-(sp)
        move.l  a3,-(sp)
        move.l  a4,-(sp)
        jsr     (a1)
        addq.l  #8,sp
        movea.l (sp)+,a0
        tst.l   d0
        beq     .seen
        bra     .step

.last   suba.l  a5,a5
        tst.l   scene_node_slots(a0)
        beq     .step
.found  move.l  a0,d0
.done   move.l  a5,near_walk_node(a4)
        move.l  a2,near_walk_last(a4)
        movea.l d0,a0                   ; where GCC expects a pointer
        return_all
.end    moveq   #0,d0
        suba.l  a5,a5
        bra.s   .done
