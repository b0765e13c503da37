        include "routine.i"

; mesh_mirror - u and v of an environment in a map of 256x256, from normals to the places of points
;
; in:      a0  const struct values_plan*  marks of one point at least
; reads:   the plan, six factors, the marks, normals of points that are marked
; writes:  u and v of their entries at to
; formats: normals 2.14, -1 to 1; factors 9.7; u and v as in struct snapped_vertex: 12.20, raised
; error:   0 to 1/65536 texel too low (floor), once for the sum; mesh_attributes has the same s and t

; The next value of the normal a0, to (a1)+. \1 to \3: its factors. a3 the middle, a5 the greatest,
; a6 what is added. Uses d0/d1.
value   macro
        move.w  \1,d0
        muls.w  (a0),d0                 ; scene_normal_x
        move.w  \2,d1
        muls.w  scene_normal_y(a0),d1
        add.l   d1,d0
        move.w  \3,d1
        muls.w  scene_normal_z(a0),d1
        add.l   d1,d0
        asr.l   #5,d0                   ; 21 fraction bits -> 16
        add.l   a3,d0
        cmp.l   a5,d0
        bls.s   .inside\@
        spl     d0                      ; above it, else below 0
        extb.l  d0
        move.l  a5,d1
        and.l   d1,d0
.inside\@
        add.l   a6,d0
        lsl.l   #4,d0
        move.l  d0,(a1)+
        endm

        routine mesh_mirror,a0
        save_all
        movea.l values_plan_factors(a0),a1
        movem.w (a1),d2-d7
        movea.l values_plan_to(a0),a1
        addq.l  #mesh_place_u,a1
        movea.l values_plan_marks(a0),a4
        movea.l values_plan_from(a0),a0
        movea.l #128<<16,a3
        movea.l #256<<16,a5
        movea.w #SNAPPED_RAISED,a6
        bra.s   .next
.skip   addq.l  #scene_normal_sizeof,a0
        lea     mesh_place_sizeof(a1),a1
.next   tst.b   (a4)+
        beq.s   .skip
        bpl.s   .end                    ; MARKS_END
.normal value   d2,d3,d4
        value   d5,d6,d7
        addq.l  #scene_normal_sizeof,a0
        addq.l  #mesh_place_sizeof-8,a1
        tst.b   (a4)+
        bmi.s   .normal
        beq.s   .skip
.end    return_all
