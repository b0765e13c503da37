        include "span.i"

; span_gouraud - draws a scanline table with interpolated shades
;
; in:      a0  span_plan*  the table, the frame, the step dudx
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start0 = ss, start1 = SS)
; writes:  the pixels of the lines, nothing else
; formats: s 16.16, pixels are its integer modulo 256; dudx is shades a pixel, used
;          modulo 256, as -128 to 127.99: s changes by 64,000 a line at most
; error:   none: pixel n is floor(s + n dudx)

; A chain of one register, as pack_alone packs it; MOVE, JMP and DBRA keep X between
; pixels.

        span span_gouraud
        span_open
        move.l  span_plan_dudx(a0),d2
        span_table
        pack_alone d2,d5,a4
        move.l  (sp),d4
        lea     .pixels_end-4(pc),a3
        span_line d0
        span_rounds 5
        move.b  d0,d5
        move.w  d5,d0
        add.l   a4,d0
        jmp     (a3,d6.w*4)
.pixels rept    32
        pixel_shade
        endr
        span_close d4
