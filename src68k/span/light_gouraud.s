        include "span.i"

; span_light_gouraud - puts the pixels of a scanline table through a light table, each at its level
;
; in:      a0  span_plan*  the table, the frame, the light, the step dcdx
; trashes: d0-d7/a0-a6
; reads:   the plan, left and last of its lines, their pixels, their shades (c-Cc, as
;          edge_shade packs them, with LEVEL_FALLS if dcdx is negative), the light table
; writes:  the pixels of the lines, nothing else
; formats: 8-bit chunky pixels; levels 6.16, inside the light table at every pixel
; error:   none: pixel p, n pixels on, becomes light[256 floor(c + n dcdx) + p]

; A chain of one register: c carries into Cc, a pixel later, so c is one step ahead. Cc never
; carries into the spare byte where levels rise. Where they fall it always does; the
; spare byte, FF in the step, carries on into c, and so the step of c is one less.

        span span_light_gouraud
        span_open
        move.l  span_plan_dcdx(a0),d3
        move.l  span_plan_light(a0),d2  ; ll--
        movea.l span_plan_shades(a0),a3
        span_table
        ror.l   #8,d3                   ; c-Cc
        tst.w   d3
        bpl.s   .rises
        borrow  d3,1<<24,w
.rises  ahead   d3,d5,a4,w
        lea     .pixels_end-10(pc),a2
        move.l  a2,d4
        bra.s   .line
.empty  addq.l  #4,a3
        bra     .line_next
.line   move.l  (a0)+,d0                ; --:left
        lea     (a6,d0.w),a1
        move.w  (a0),d7
        addq.l  #8,a0
        sub.w   d0,d7
        bmi.s   .empty
        move.l  (a3)+,d1
        span_rounds 4
        movea.l d4,a2
        lea     (a2,d6.w*2),a2
        add.l   a4,d1
        jmp     (a2,d6.w*8)
.pixels rept    16
        move.w  d1,d2                   ; llCc
        move.b  (a1),d2                 ; ll, C and the pixel
        addx.l  d3,d1
        movea.l d2,a2
        move.b  (a2),(a1)+
        endr
        span_close (sp)
