        include "routine.i"

; n64_stages_draw - a polygon's lines, each by a list of passes
;
; in:      a0  n64_stages*  the passes, and where lines begin
;          a1  const scanline*  left and last of each line
;          d0  int32  lines, 1 at least
; reads:   the planes; what the passes read
; writes:  the stages' starts, at and pixels; what the passes write
; formats: planes modulo 2^32
; cost:    about 250 cycles a line and 60 a pass beside the passes; 60 a further plane

; What the passes write between them has room for N64_LINE_PIXELS; longer lines are drawn in parts.

        routine n64_stages_draw,a0,a1,d0
        save_all
        movea.l a0,a5
        movea.l a1,a6
        move.l  d0,-(sp)
        move.w  n64_stages_interpolants+2(a5),d3
        subq.w  #1,d3
.line   moveq   #0,d6
        move.w  scanline_left(a6),d6
        move.w  scanline_last(a6),d7
        ext.l   d7
        sub.l   d6,d7
        addq.l  #1,d7                   ; pixels
        ble     .down
        sub.l   #EDGE_BIAS,d6
.part   move.l  #N64_LINE_PIXELS,d5
        cmp.l   d5,d7
        bge.s   .long
        move.l  d7,d5
.long   movea.l n64_stages_planes(a5),a0
        lea     n64_stages_starts(a5),a1
        lea     n64_stages_at(a5),a2
        move.l  d6,d1
        sub.l   n64_stages_column(a5),d1
        move.w  d3,d2
.value  move.l  plane_dx(a0),d0
        muls.l  d1,d0
        add.l   (a1)+,d0
        move.l  d0,(a2)+
        lea     plane_sizeof(a0),a0
        dbra    d2,.value
        move.l  n64_stages_pixel_bits(a5),d0
        move.l  d6,d4
        lsl.l   d0,d4
        add.l   n64_stages_pixels(a5),d4
        lea     n64_stages_of(a5),a3
        bra.s   .first
.stage  move.l  a0,d0
        bne.s   .read
        movea.l d4,a0
.read   move.l  a1,d0
        bne.s   .written
        movea.l d4,a1
.written
        move.l  d5,d0
        jsr     PASS_SAVED(a4)
.first  movem.l (a3)+,a0-a2/a4
        move.l  a4,d0
        bne.s   .stage
        add.l   d5,d6
        sub.l   d5,d7
        bne.s   .part
.down   movea.l n64_stages_planes(a5),a0
        lea     n64_stages_starts(a5),a1
        move.w  d3,d2
.start  move.l  plane_dy(a0),d0
        add.l   d0,(a1)+
        lea     plane_sizeof(a0),a0
        dbra    d2,.start
        move.l  n64_stages_pitch(a5),d0
        add.l   d0,n64_stages_pixels(a5)
        lea     scanline_sizeof(a6),a6
        subq.l  #1,(sp)
        bne     .line
        addq.l  #4,sp
        return_all
