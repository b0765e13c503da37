        include "eye.i"

; mesh_near_seen - the next slot of a node, from the last one on, whose face is seen from the front
;
; in:      a0  struct near_face*  slot is behind the next one, slots the one where to end
; out:     d0  const struct near_slot*  the slot; 0: there is none left
; reads:   the plan, its view's eye, slots, their faces
; writes:  slot
; formats: normals 2.30, eye and distance 16.16
; error:   mesh_faces_wide's
; cost:    bench row mesh_near_seen: a face from the back
        routine mesh_near_seen,a0
        movem.l d2-d3/d5-d7/a2-a3,-(sp)
        movea.l near_face_view(a0),a1
        movem.l scene_view_eye_x(a1),d5-d7
        movea.l near_face_slot(a0),a2
        movea.l near_face_slots(a0),a3
.slot   cmpa.l  a3,a2
        beq.s   .none
        subq.l  #near_slot_sizeof,a2
        move.l  (a2),d0                 ; near_slot_face
        beq.s   .slot
        movea.l d0,a1
        eye_along a1,scene_face
        cmp.l   scene_face_distance(a1),d2
        ble.s   .slot
        move.l  a2,d0
.done   move.l  a2,near_face_slot(a0)
        movea.l d0,a0                   ; where GCC expects a pointer
        movem.l (sp)+,d2-d3/d5-d7/a2-a3
        rts
.none   moveq   #0,d0
        bra.s   .done
