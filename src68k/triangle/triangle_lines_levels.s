LEVELS          equ     1

        include "triangle_chain.i"

; The level's gradient. Its step is a multiple of 4 units, and 0 where it is LEVELS_STEEP or more. Uses
; d0/d3-d7/a4.
level_gradient macro
        move.l  a6,d6
        move.w  d2,d3
        ext.l   d3
        ext.l   d1
        gradient snapped_vertex_level,a4,texel_quotient
        move.l  a4,batch_level(a5)
        move.l  d4,d0
        add.l   #LEVELS_STEEP<<16,d0
        cmp.l   #LEVELS_STEEP<<17,d0
        bcs.s   .steps\@
        moveq   #0,d4
.steps\@
        and.b   #$fc,d4
        move.l  d4,batch_light(a5)
        endm

; The plane of levels. Uses d0/d2/d7.
level_start macro
        move.l  a6,-(sp)
        value_start_wide snapped_vertex_level,batch_level(a5),batch_light(a5),a6
        move.l  a5,-(sp)
        move.l  batch_light(a5),d0
        ifc     '\1','right'
        neg.l   d0                      ; to the right
        endc
        movea.l batch_shade(a5),a5
        move.l  d0,shade_plan_dcdx(a5)
        move.l  wide_l_step+8(sp),d2
        muls.l  d0,d2
        sub.l   d2,d7                   ; straight down
        and.b   #$fc,d7
        move.l  d7,shade_plan_dcdy(a5)
        move.l  a0,d2
        ifc     '\1','right'
        subq.l  #1,d2
        endc
        muls.l  d0,d2
        move.l  a6,d0
        sub.l   d2,d0
        and.b   #$fc,d0
        move.l  d0,shade_plan_shade(a5)
        movea.l (sp)+,a5
        movea.l (sp)+,a6
        endm

; triangle_lines_levels - the scanline table of a batch's next triangle, and the plane of its levels
;
; like:    triangle_lines_addx
; reads:   the plan, its list, the vertices' x, y, u, v, level, the reciprocals
; writes:  as triangle_lines_addx; of the shade plan: dcdx, dcdy and shade if there are lines
; formats: as there; levels 16.16 in multiples of 4 units, as edge_shade reads them
; error:   as triangle_lines_addx; levels inside the triangle: 5/128 of a level below and above those
;          of the vertices, tools/tmap/ideal/bounds_snapped.py
; cost:    bench rows triangle_lines_levels
        routine triangle_lines_levels,a0
        chain_table
