        include "routine.i"

; mesh_link - faces of a mesh become triangles of a batch whose vertices are the mesh's places
;
; in:      a0  struct gather_plan*  its vertices, values and scale are not used; its placed and corners
;                                   are not set
; out:     d0  const struct mesh_face*  the first face that was not taken: the list or its room ends, the
;                                     material or the flags are others, or a is 0
; reads:   the plan, faces with their corners
; writes:  triangles; the plan's last, behind the last triangle
; formats: triangles are fans from the first corners
; cost:    bench rows mesh_link and mesh_link_quads: a face of three, of four corners

; a6 the plan, a1 the face, a4 the triangle; d0-d3 its corners, d6 full, d7 the last face's instance.
        routine mesh_link,a0
        save_all
        movea.l gather_plan_from(a0),a1
        movea.l gather_plan_list(a0),a4
        move.l  gather_plan_full(a0),d6
        moveq   #0,d7
        movea.l a0,a6
        bra.s   .face
.three  movea.l mesh_face_next(a1),a1
.face   move.l  a1,d0
        beq.s   .done
        cmp.l   a4,d6
        blo.s   .done
        cmp.l   mesh_face_placed(a1),d7
        bne.s   .other
.same   movem.l mesh_face_a(a1),d0-d3
        tst.l   d0
        beq.s   .done
        move.l  d0,(a4)+
        move.l  d1,(a4)+
        move.l  d2,(a4)+
        tst.l   d3
        beq.s   .three
        move.l  d0,(a4)+
        move.l  d2,(a4)+
        move.l  d3,(a4)+
        bra.s   .three

.other  move.l  mesh_face_placed(a1),d0
        movea.l d0,a2
        move.l  mesh_placed_material(a2),d1
        cmp.l   gather_plan_material(a6),d1
        bne.s   .done
        move.l  mesh_placed_flags(a2),d1
        cmp.l   gather_plan_flags(a6),d1
        bne.s   .done
        move.l  d0,d7
        bra.s   .same

.done   move.l  a4,gather_plan_last(a6)
        move.l  a1,d0
        movea.l d0,a0                   ; where GCC expects a pointer
        return_all
