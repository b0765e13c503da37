        include "routine.i"

; mesh_shade - shades of a light, from normals to the places of points
;
; in:      a0  const struct values_plan*  marks of one point at least
; reads:   the plan, three factors, the marks, normals of points that are marked
; writes:  u of their entries at to
; formats: normals 2.14, -1 to 1; factors 9.7; low and high 16.16; u as in struct snapped_vertex: the
;          shade in 12.20, raised
; error:   0 to 1/65536 too low (floor), once for the sum, then kept SHADE_INSET inside its whole
;          shade's range as mesh_gather does
        routine mesh_shade,a0
        movem.l d2-d7/a2-a3,-(sp)
        movea.l values_plan_factors(a0),a1
        move.w  (a1)+,d2
        move.w  (a1)+,d3
        move.w  (a1),d4
        movem.l values_plan_low(a0),d6-d7
        movea.l values_plan_to(a0),a1
        addq.l  #mesh_place_u,a1
        movea.l values_plan_marks(a0),a3
        movea.l values_plan_from(a0),a0
        move.w  #-1-SHADE_INSET,d5
        movea.w #SNAPPED_RAISED,a2
        bra.s   .next
.skip   addq.l  #scene_normal_sizeof,a0
        lea     mesh_place_sizeof(a1),a1
.next   tst.b   (a3)+
        beq.s   .skip
        bpl.s   .end                    ; MARKS_END
.normal move.w  d2,d0
        muls.w  (a0),d0                 ; scene_normal_x
        move.w  d3,d1
        muls.w  scene_normal_y(a0),d1
        add.l   d1,d0
        move.w  d4,d1
        muls.w  scene_normal_z(a0),d1
        add.l   d1,d0
        addq.l  #scene_normal_sizeof,a0
        asr.l   #5,d0                   ; 21 fraction bits -> 16
        add.l   d6,d0
        cmp.l   d6,d0
        bge.s   .not_low
        move.l  d6,d0
.not_low
        cmp.l   d7,d0
        ble.s   .not_high
        move.l  d7,d0
.not_high
        cmp.w   #SHADE_INSET,d0
        bhs.s   .least
        move.w  #SHADE_INSET,d0
.least  cmp.w   d5,d0
        bls.s   .greatest
        move.w  d5,d0
.greatest
        add.l   a2,d0
        lsl.l   #4,d0
        move.l  d0,(a1)
        lea     mesh_place_sizeof(a1),a1
        tst.b   (a3)+
        bmi.s   .normal
        beq.s   .skip
.end    movem.l (sp)+,d2-d7/a2-a3
        rts
