        include "transform.i"

; mesh_project - projects vertices from the camera's space to the screen, as mesh_transform_wide does
;
; in:      a0  struct vertex*  inside all borders
;          d0  int32           how many, 1 or more
;          a1  const struct near_frame*  width, height, guard
; reads:   the frame's width, height and guard; x, y, w of the vertices
; writes:  their x and y
; formats: 16.16
; error:   half a unit
; cost:    about 230 cycles a vertex

middle_x equ    0                       ; on the stack
middle_y equ    4

        routine mesh_project,a0,d0,a1
        movem.l d2-d7/a2-a4,-(sp)
        movea.l a0,a2
        move.w  d0,d7
        subq.w  #1,d7
        moveq   #15,d2
        movem.l near_frame_width(a1),d0-d1    ; and height
        lsl.l   d2,d0
        lsl.l   d2,d1
        movem.l d0-d1,-(sp)
        movea.l sp,a4
        move.l  near_frame_guard(a1),d0
        moveq   #16,d5
        moveq   #16,d6
        add.l   d0,d5
        sub.l   d0,d6
        moveq   #0,d4
.vertex move.l  vertex_w(a2),d2
        move.l  d2,d3
        lsr.l   #1,d3
        movem.l (a2),a0-a1              ; vertex_x, vertex_y
        point_screen a0,middle_x
        point_screen a1,middle_y
        lea     vertex_sizeof-8(a2),a2
        dbra    d7,.vertex
        addq.l  #8,sp
        movem.l (sp)+,d2-d7/a2-a4
        rts
