        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"

;==============================================================================
; span_lit_wrap - the same where v wraps more than once in a span
;
; in:      a0  span_plan*  the table, the frame, the map, the row, the steps
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map,
;          256 bytes at light, a multiple of 256
; writes:  the pixels of the lines, nothing else
; formats: as span_affine_addx_wrap
; error:   none: pixel n shows light[texel (floor(u + n dudx), floor(v + n dvdx))]
; cost:    bench row affine_lit_wrap
;==============================================================================

pixel   macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        add.l   a4,d5
        addx.l  d3,d1
        addx.w  d2,d0
        movea.l d4,a2
        move.b  (a2),d6
        movea.l d6,a2
        move.b  (a2),(a1)+
        endm

        routine span_lit_wrap,a0
        span_open
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_light(a0),-(sp)
        move.l  span_plan_dudx(a0),d5
        move.l  span_plan_dvdx(a0),d2
        span_table
        pack_uv d5,d2,d3                ; d5 uu--, d2 .Vv, d3 v--U
        movea.l d5,a4
        lea     .pixels_end-18(pc),a3
        span_line d0,d1
        move.l  d0,d5                   ; uu.. (Vv below it is never carried)
        clr.w   d5
        span_rounds 3
        lea     (a3,d6.w*2),a2
        lea     (a2,d6.w*8),a2
        lea     (a2,d6.w*8),a2
        move.l  (sp),d6                 ; lll0
        jmp     (a2)
.pixels rept    8
        pixel
        endr
        span_close 4(sp),8
