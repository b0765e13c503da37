        include "routine.i"

; mesh_mirror - u and v of an environment, from normals to the places of points
;
; in:      a0  const struct values_plan*  marks of one point at least
; reads:   the plan, six factors, the marks, normals of points that are marked
; writes:  u and v of their entries at to
; formats: normals 2.14, -1 to 1; factors 9.7; s and t 16.16, u and v those >> shift as in struct
;          snapped_vertex: 12.20, raised
; error:   s and t 0 to 1/65536 too low (floor), once for the sum, the same as mesh_attributes'; half of
;          1/65536 texel for the shift, the same as triangle_vertices' for its scale
; cost:    bench rows mesh_mirror, mesh_mirror_shifted

; The next value of the normal a0, to (a1)+. \1 to \3: its factors. \4: shifted, by (sp), or not. a3 the
; middle, a5 the greatest, a6 what is added. Uses d0/d1.
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
        ifc     '\4','shifted'
        move.l  (sp),d1
        lsr.l   d1,d0
        moveq   #0,d1
        addx.l  d1,d0                   ; to the nearest
        endc
        add.l   a6,d0
        lsl.l   #4,d0
        move.l  d0,(a1)+
        endm

; The marked normals from the mark a4 on. \1: as \4 of value.
values  macro
        bra.s   .next\@
.skip\@ addq.l  #scene_normal_sizeof,a0
        lea     mesh_place_sizeof(a1),a1
.next\@ tst.b   (a4)+
        beq.s   .skip\@
        bpl     mirror_end              ; MARKS_END
.normal\@
        value   d2,d3,d4,\1
        value   d5,d6,d7,\1
        addq.l  #scene_normal_sizeof,a0
        addq.l  #mesh_place_sizeof-8,a1
        tst.b   (a4)+
        bmi     .normal\@
        beq     .skip\@
        bra     mirror_end
        endm

        routine mesh_mirror,a0
        save_all
        movea.l values_plan_factors(a0),a1
        movem.w (a1),d2-d7
        movea.l values_plan_to(a0),a1
        addq.l  #mesh_place_u,a1
        movea.l values_plan_marks(a0),a4
        move.l  values_plan_shift(a0),-(sp)
        movea.l values_plan_from(a0),a0
        movea.l #128<<16,a3
        movea.l #256<<16,a5
        movea.w #SNAPPED_RAISED,a6
        tst.l   (sp)
        bne     .shifted
        values  whole
.shifted
        values  shifted
mirror_end
        addq.l  #4,sp
        return_all
