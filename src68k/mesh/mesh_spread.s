        include "routine.i"

; mesh_spread - sorts faces into a list, by buckets of orders
;
; in:      a0  struct mesh_face*  first face; their orders are read, next is written
;          d0  int32  how many, 1 at least
;          a1  struct mesh_face**  scratch memory, MESH_SORT_BUCKETS entries
; out:     d0  struct mesh_face*  the list's first, of the least order, those of the same order as they
;                                 came; 0: more than 1 << MESH_SORT_STEPS_LOG steps a face would be needed, and
;                                 next of every face may be anything
; reads:   faces
; writes:  next of faces; the buckets
; formats: orders unsigned

; a2 the buckets, a4 the first face, a5 the last; d2 the least order, d3 the shift to a bucket's number,
; d5 steps left.
        routine mesh_spread,a0,d0,a1
        save_all
        movea.l a1,a2
        movea.l a0,a4
        move.l  d0,d5
        lsl.l   #MESH_SORT_STEPS_LOG,d5
        lsl.l   #5,d0                   ; mesh_face_sizeof
        lea     -mesh_face_sizeof(a0,d0.l),a5
        move.l  (a0),d2                 ; mesh_face_order
        move.l  d2,d4
        bra.s   .ends
.extent move.l  (a0),d0
        cmp.l   d2,d0
        bhs.s   .not_least
        move.l  d0,d2
.not_least
        cmp.l   d4,d0
        bls.s   .ends
        move.l  d0,d4
.ends   lea     mesh_face_sizeof(a0),a0
        cmpa.l  a5,a0
        bls.s   .extent
        sub.l   d2,d4
        moveq   #0,d3
.shift  cmp.l   #MESH_SORT_BUCKETS,d4
        blo.s   .fits
        lsr.l   #1,d4
        addq.l  #1,d3
        bra.s   .shift
.fits   moveq   #0,d0
        moveq   #MESH_SORT_BUCKETS/8-1,d1
.clear  move.l  d0,(a1)+
        move.l  d0,(a1)+
        move.l  d0,(a1)+
        move.l  d0,(a1)+
        move.l  d0,(a1)+
        move.l  d0,(a1)+
        move.l  d0,(a1)+
        move.l  d0,(a1)+
        dbra    d1,.clear
        movea.l a1,a6                   ; behind the buckets

; From the last face on: each comes before those of its order.
.face   move.l  (a5),d0
        move.l  d0,d1
        sub.l   d2,d1
        lsr.l   d3,d1
        lea     (a2,d1.l*4),a1
        move.l  (a1),d4
        beq.s   .place
.walk   movea.l d4,a3
        cmp.l   (a3),d0
        bls.s   .place
        subq.l  #1,d5
        bmi.s   .crowded
        lea     mesh_face_next(a3),a1
        move.l  (a1),d4
        bne.s   .walk
.place  move.l  d4,mesh_face_next(a5)
        move.l  a5,(a1)
        lea     -mesh_face_sizeof(a5),a5
        cmpa.l  a4,a5
        bhs.s   .face

; From the last bucket on: d0 the list so far.
        moveq   #0,d0
.bucket move.l  -(a6),d1
        beq.s   .empty
        move.l  d1,d4
.tail   movea.l d4,a3
        move.l  mesh_face_next(a3),d4
        bne.s   .tail
        move.l  d0,mesh_face_next(a3)
        move.l  d1,d0
.empty  cmpa.l  a2,a6
        bne.s   .bucket
.done   movea.l d0,a0                   ; where GCC expects a pointer
        return_all
.crowded
        moveq   #0,d0
        bra.s   .done
