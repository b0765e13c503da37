        include "span.i"

; span_affine_swap - draws a scanline table from a 256x256 map, by add and swap
;
; like:    span_affine_addx
; reads:   the plan, its lines (start0 = uu, start1 = UU, start2 = VVvv), the map
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels

; The best form found without addx: v is held 8 bits higher, so that V is above U once
; u's lower bytes have replaced v's, and one swap makes both an index.

        span span_affine_swap
        span_open
        movea.l span_plan_map(a0),a4
        adda.l  #32768,a4               ; the index is signed: v starts 128 rows on
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d3
        lsl.l   #8,d3
        move.l  #$ffffff,d5
        span_table
        lea     .pixels_end-18(pc),a3
        span_line d0,d1
        swap    d0
        lsl.l   #8,d1
        bchg    #31,d1
        span_rounds 3
        span_enter 2,8
.pixels rept    8
        join_uv d5
        add.l   d2,d0
        add.l   d3,d1
        move.b  (a4,d4.w),(a1)+
        endr
        span_close (sp)
