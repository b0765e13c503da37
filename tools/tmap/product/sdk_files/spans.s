; Turns a map into a frame by span_affine_addx and the frame into eight bitplanes by c2p_8, which
; it saves as "planes": 160x128 pixels.

        include "tmap020.i"
        xref    save                    ; start.s
        xdef    _main

WIDTH           equ     160
HEIGHT          equ     128
DUDX            equ     $c000           ; texels in 16.16: a turn by 27 degrees, 19 % larger
DVDX            equ     $6000

        section .text,code
_main:
        movem.l d2-d5/a2-a4,-(sp)
        move.l  #room+65535,d0
        clr.w   d0
        movea.l d0,a2                   ; the map: a page at a multiple of 65,536
        movea.l a2,a3
        adda.l  #65536,a3               ; the frame, the planes behind it
        moveq   #0,d1
.texel  move.w  d1,d0                   ; v:u
        lsr.w   #8,d0
        eor.b   d1,d0
        move.b  d0,(a2,d1.l)
        addq.w  #1,d1
        bne.s   .texel

; The scanline table: u and v where each line begins, packed as the addx chain has them.
        lea     lines,a4
        moveq   #0,d2                   ; u
        moveq   #0,d3                   ; v
        move.w  #HEIGHT-1,d5
.line   move.w  d2,scanline_start0(a4)
        move.w  #EDGE_BIAS,scanline_left(a4)
        move.w  #EDGE_BIAS+WIDTH-1,scanline_last(a4)
        move.l  d3,d0
        lsr.l   #8,d0
        move.w  d0,scanline_start1(a4)  ; Vv
        move.l  d2,d0
        swap    d0
        and.l   #$ff,d0                 ; U
        move.l  d3,d1
        ror.l   #8,d1
        and.l   #$ff000000,d1
        or.l    d1,d0
        move.l  d0,scanline_start2(a4)  ; v--U
        sub.l   #DVDX,d2
        add.l   #DUDX,d3
        lea     scanline_sizeof(a4),a4
        dbra    d5,.line

        lea     plan,a0
        move.l  #lines,span_plan_lines(a0)
        move.l  #HEIGHT,span_plan_count(a0)
        lea     -EDGE_BIAS(a3),a1
        move.l  a1,span_plan_row(a0)
        move.l  #WIDTH,span_plan_pitch(a0)
        move.l  a2,span_plan_map(a0)
        move.l  #DUDX,span_plan_dudx(a0)
        move.l  #DVDX,span_plan_dvdx(a0)
        move.l  a3,-(sp)                ; a span changes all registers
        jsr     span_affine_addx
        movea.l (sp)+,a3

        lea     planar,a0
        move.l  a3,planar_plan_pixels(a0)
        move.l  #WIDTH,planar_plan_pitch(a0)
        move.l  #WIDTH,planar_plan_width(a0)
        move.l  #HEIGHT,planar_plan_rows(a0)
        lea     WIDTH*HEIGHT(a3),a4
        move.l  a4,planar_plan_planes(a0)
        move.l  #WIDTH/8,planar_plan_row_pitch(a0)
        move.l  #WIDTH/8*HEIGHT,planar_plan_plane_pitch(a0)
        jsr     c2p_8

        move.l  #name,d0
        move.l  a4,d1
        movea.l #WIDTH*HEIGHT,a0
        jsr     save
        subq.l  #1,d0
        and.l   #10,d0                  ; 0 saved, else 10
        movem.l (sp)+,d2-d5/a2-a4
        rts
name    dc.b    'planes',0
        even

        section .bss,bss
plan    ds.b    span_plan_sizeof
planar  ds.b    planar_plan_sizeof
lines   ds.b    HEIGHT*scanline_sizeof
room    ds.b    3*65536
