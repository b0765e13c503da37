; A point from a mesh's space to the camera's and the screen.

        include "routine.i"

; d2 = a coordinate; d5-d7 the point in 14.18, a1 a row: the move and half a unit, 32.32, and three factors, 2.30.
; The sum has 48 fraction bits, so its upper longword is the result.
point_row macro
        movem.l (a1)+,d2-d3
        move.l  d5,d0
        muls.l  (a1)+,d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        move.l  d6,d0
        muls.l  (a1)+,d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        move.l  d7,d0
        muls.l  (a1)+,d1:d0
        add.l   d0,d3
        addx.l  d1,d2
        endm

; Projects \1, x or y, to the screen; \2: the middle. d2 depth, d3 half of it, d4 0, d5
; 16 + guard, d6 16 - guard.
point_screen macro
        move.l  \1,d0
        move.l  d0,d1
        asr.l   d6,d1
        lsl.l   d5,d0
        add.l   d3,d0
        addx.l  d4,d1
        divs.l  d2,d1:d0                ; towards zero: remainder of the dividend's sign
        tst.l   d1
        minus   <subq.l #1,d0>
        add.l   \2(a4),d0
        move.l  d0,(a2)+
        endm

; Transforms the point at a0, which is moved on, to the mesh_point at a2, which is moved to its outside; d4 = that. a1:
; three rows; \1 at a4 has near_plane, middle_x and middle_y; \2: 16 + guard, 16 - guard. \3: the label of code that
; goes on at a2's screen_x of a point outside borders d4, or nothing. Uses d0-d7/a3/a6.
transform_point macro
        movem.l (a0)+,d5-d7
        lsl.l   #2,d5
        lsl.l   #2,d6
        lsl.l   #2,d7
        point_row
        movea.l d2,a3                   ; x
        point_row
        movea.l d2,a6                   ; y
        point_row
        move.l  a3,(a2)+
        move.l  a6,(a2)+
        move.l  d2,(a2)+

        moveq   #0,d4
        cmp.l   \1_near_plane(a4),d2
        bge.s   .far\@
        moveq   #MESH_NEAR,d4
.far\@  move.l  d2,d3
        neg.l   d3
        cmp.l   a3,d3
        ble.s   .left\@
        addq.w  #MESH_LEFT,d4
.left\@ cmp.l   a3,d2
        bge.s   .right\@
        addq.w  #MESH_RIGHT,d4
.right\@
        cmp.l   a6,d3
        ble.s   .above\@
        addq.w  #MESH_ABOVE,d4
.above\@
        cmp.l   a6,d2
        bge.s   .below\@
        add.w   #MESH_BELOW,d4
.below\@
        tst.w   d4
        ifb     \3
        bne.s   .outside\@
        else
        bne     \3
        endc
        movem.l \2,d5-d6
        move.l  d2,d3
        lsr.l   #1,d3
        point_screen a3,\1_middle_x
        point_screen a6,\1_middle_y
        move.l  d4,(a2)
        ifb     \3
        bra.s   .done\@
.outside\@
        addq.l  #8,a2
        move.l  d4,(a2)
.done\@
        endc
        endm
