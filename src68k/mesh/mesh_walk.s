        include "eye.i"

; mesh_walk - the faces in a tree's slots as a list, back to front as seen from the eye
;
; in:      a0  const struct walk_plan*  a tree
; out:     d0  struct mesh_face*  the list's first; 0: all slots are empty
; reads:   the plan, its view's eye, the tree's nodes, its slots
; writes:  next of the faces; 0 to all slots; steps
; formats: normals 2.30, eye and distance 16.16
; error:   none, if normal * eye is less than 2^31: the eye is in front if that is distance or more
; cost:    bench row mesh_walk for a node that divides others, with an empty slot; 70 cycles for another node,
;          20 for a further slot

; a0 the node, a1 the slots, a2 the next step, a3 the first step, a4 where the next face goes, a5 the
; nearer of both half spaces' nodes, a6 the slot; d5-d7 the eye.

; To the list: the faces in the slots of a0, which become 0. Uses d0/d4/a6.
faces   macro
        move.l  scene_node_slots(a0),d4
        beq.s   .listed\@
        move.l  scene_node_slot(a0),d0
        lea     (a1,d0.l*4),a6
.slot\@ move.l  (a6)+,d0
        beq.s   .empty\@
        clr.l   -4(a6)
        move.l  d0,(a4)
        movea.l d0,a4
        addq.l  #mesh_face_next,a4
.empty\@
        subq.l  #1,d4
        bne.s   .slot\@
.listed\@
        endm

        routine mesh_walk,a0
        save_all
        movea.l walk_plan_view(a0),a1
        movem.l scene_view_eye_x(a1),d5-d7
        movea.l walk_plan_slots(a0),a1
        movea.l walk_plan_steps(a0),a2
        movea.l a2,a3
        movea.l walk_plan_root(a0),a0
        clr.l   -(sp)
        movea.l sp,a4
.node   move.l  scene_node_front(a0),d4
        or.l    scene_node_back(a0),d4
        beq     .last
        eye_along a0,scene_node
        move.l  scene_node_front(a0),d0
        move.l  scene_node_back(a0),d1
        move.l  d0,d3
        lsl.l   #5,d3                   ; scene_node_sizeof
        move.l  a0,(a2)+
        cmp.l   scene_node_distance(a0),d2
        lea     scene_node_sizeof(a0),a5
        blt.s   .behind
        add.l   a5,d3
        tst.l   d0
        bne.s   .nearer
        suba.l  a5,a5
.nearer move.l  a5,(a2)+
        movea.l d3,a0
        tst.l   d1
        bne.s   .node
        bra.s   .step
.behind movea.l a5,a0
        adda.l  d3,a5
        tst.l   d1
        bne.s   .back
        suba.l  a5,a5
.back   move.l  a5,(a2)+
        tst.l   d0
        bne.s   .node
.step   cmpa.l  a3,a2
        beq.s   .end
        movea.l -(a2),a5
        movea.l -(a2),a0
        faces
        movea.l a5,a0
        move.l  a5,d0
        beq.s   .step
        bra     .node
.last   faces
        bra.s   .step
.end    clr.l   (a4)
        move.l  (sp)+,d0
        movea.l d0,a0                   ; where GCC expects a pointer
        return_all
