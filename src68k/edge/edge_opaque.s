        include "routine.i"

; edge_opaque - leaves out of a table's lines the pixels before and behind the opaque texels of their row
;
; in:      a0  opaque_plan*  the table, the step of u, the map's rows
; reads:   the plan, its lines, the rows
; writes:  the lines (addx form): left, last, start0 and U of those that begin or end outside their row's opaque
;          texels; of all that have pixels the byte before U: 1 if texels may be transparent, else 0
; formats: u 8.16; dudx -62 to 62 texels a pixel. A line that leaves its repetition of the map keeps its ends
; error:   none: a pixel stays if its texel is from the row's first opaque one to the last

; Lines for span_keyed_rows, whose texels are in one row. x is u in its repetition of the map.

; d1 = the steps of \3, positive, from \1 to \2 at most.
pixels_to macro
        move.l  \2,d1
        sub.l   \1,d1
        divu.l  \3,d1
        endm

        routine edge_opaque,a0
        save_all
        movea.l opaque_plan_lines(a0),a3
        movea.l opaque_plan_rows(a0),a4
        move.l  opaque_plan_dudx(a0),d2
        lsl.l   #8,d2
        asr.l   #8,d2
        move.l  opaque_plan_width(a0),d3
        swap    d3
        subq.l  #1,d3                   ; the last x
        move.l  opaque_plan_height(a0),d1
        subq.w  #1,d1
        movea.w d1,a5
        move.l  opaque_plan_count(a0),d7
.line   move.w  scanline_last(a3),d6
        sub.w   scanline_left(a3),d6
        bmi     .next
        ext.l   d6                      ; pixels behind the first
        move.b  scanline_start2+3(a3),d0
        swap    d0
        move.w  scanline_start0(a3),d0  ; --UUuuuu
        and.l   d3,d0                   ; x of the first pixel
        muls.l  d2,d6
        bvs     .open
        add.l   d0,d6                   ; x of the last one
        cmp.l   d3,d6
        bhi     .open
        moveq   #0,d1
        move.b  scanline_start1(a3),d1
        move.w  a5,d4
        and.w   d4,d1
        lea     (a4,d1.w*4),a2
        moveq   #0,d4
        move.b  map_row_first(a2),d4
        swap    d4                      ; the least x that is opaque
        moveq   #0,d5
        move.b  map_row_last(a2),d5
        addq.w  #1,d5
        swap    d5
        subq.l  #1,d5                   ; the greatest
        cmp.l   d4,d5
        blt     .none
        tst.l   d2
        bmi.s   .falls

        ; u rises
        cmp.l   d5,d0
        bgt     .none
        cmp.l   d4,d6
        blt     .none
        cmp.l   d5,d6
        ble.s   .ends
        pixels_to d0,d5,d2
        add.w   scanline_left(a3),d1
        move.w  d1,scanline_last(a3)
.ends   cmp.l   d4,d0
        bge.s   .cut
        subq.l  #1,d4
        pixels_to d0,d4,d2              ; those before it, less one
        bra.s   .begin

.falls  cmp.l   d4,d0
        blt.s   .none
        cmp.l   d5,d6
        bgt.s   .none
        neg.l   d2
        cmp.l   d4,d6
        bge.s   .lasts
        pixels_to d4,d0,d2
        add.w   scanline_left(a3),d1
        move.w  d1,scanline_last(a3)
.lasts  move.l  d2,d6
        neg.l   d2
        cmp.l   d5,d0
        ble.s   .cut
        addq.l  #1,d5
        pixels_to d5,d0,d6
.begin  addq.l  #1,d1
        add.w   d1,scanline_left(a3)
        muls.l  d2,d1
        move.b  scanline_start2+3(a3),d0
        swap    d0
        move.w  scanline_start0(a3),d0
        add.l   d1,d0
        move.w  d0,scanline_start0(a3)
        swap    d0
        move.b  d0,scanline_start2+3(a3)
.cut    move.b  map_row_holes(a2),scanline_start2+2(a3)
.next   lea     scanline_sizeof(a3),a3
        subq.l  #1,d7
        bne     .line
        return_all
.open   move.b  #1,scanline_start2+2(a3)
        bra.s   .next
.none   move.w  scanline_left(a3),d1
        subq.w  #1,d1
        move.w  d1,scanline_last(a3)
        bra.s   .next
