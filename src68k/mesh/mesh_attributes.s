        include "routine.i"

; mesh_attributes - the values that a light or an environment map gives to normals
;
; in:      a0  const struct attribute_plan*  count is 1 at least
; reads:   the plan, three factors, count normals
; writes:  to and the same field of the following entries, count in all
; formats: normals 2.14, -1 to 1; factors 9.7; base, low, high and results 16.16
; error:   0 to 1/65536 too low (floor), once for the sum
        routine mesh_attributes,a0
        movem.l d2-d7/a2-a3,-(sp)
        movea.l attribute_plan_factors(a0),a1
        move.w  (a1)+,d2
        move.w  (a1)+,d3
        move.w  (a1),d4
        move.l  attribute_plan_base(a0),d5
        move.l  attribute_plan_low(a0),d6
        movea.l attribute_plan_high(a0),a2
        movea.l attribute_plan_from(a0),a1
        move.l  attribute_plan_count(a0),d7
        lea     (a1,d7.l*8),a3
        movea.l attribute_plan_to(a0),a0
.normal move.w  d2,d0
        muls.w  (a1),d0                 ; scene_normal_x
        move.w  d3,d1
        muls.w  scene_normal_y(a1),d1
        add.l   d1,d0
        move.w  d4,d1
        muls.w  scene_normal_z(a1),d1
        add.l   d1,d0
        addq.l  #scene_normal_sizeof,a1
        asr.l   #5,d0                   ; 21 fraction bits -> 16
        add.l   d5,d0
        cmp.l   d6,d0
        bge.s   .not_low
        move.l  d6,d0
.not_low
        cmp.l   a2,d0
        ble.s   .not_high
        move.l  a2,d0
.not_high
        move.l  d0,(a0)
        lea     mesh_attributes_sizeof(a0),a0
        cmpa.l  a3,a1
        blo.s   .normal
        movem.l (sp)+,d2-d7/a2-a3
        rts
