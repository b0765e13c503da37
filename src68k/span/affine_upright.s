        include "span.i"

; Draws a pixel and goes on to the one below it, a3 bytes on. 16 bytes.
pixel_upright macro
        texel_next_apart d2,d3
        movea.l d4,a2
        move.b  (a2),(a1)
        adda.l  a3,a1
        endm

; span_affine_upright - span_affine_scanline for columns of the frame
;
; in:      a0  span_plan*  the table, the frame, the map, a table of steps
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), their
;          steps, the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 16.16, both wrap at 256; 8-bit texels and pixels; pitch: bytes from a line's pixel to its
;          next; the next line is a byte further
; error:   none: u, v are stepped with all their bits
        span span_affine_upright
        span_open
        movea.l (sp),a3
        move.l  span_plan_steps(a0),(sp)
        move.l  span_plan_map(a0),d4    ; mm00
        span_table
.line   move.l  (a0)+,d0                ; start0:left
        moveq   #0,d6
        move.w  d0,d6
        move.l  (a0)+,d7                ; last:start1
        move.w  d7,d0
        swap    d7
        sub.w   d6,d7
        bmi     .empty
        move.l  a3,d1
        muls.l  d1,d6
        lea     (a6,d6.l),a1
        move.l  (a0)+,d1
        movea.l (sp),a2
        move.l  (a2)+,d5
        move.l  (a2),d2
        apart_steps
        apart_start
        span_rounds_out 3
        span_enter_out 8
.pixels rept    8
        pixel_upright
        endr
        dbra    d7,.pixels
.line_next
        addq.l  #8,(sp)
        addq.l  #1,a6
        cmpa.l  a5,a0
        bne     .line
        addq.l  #4,sp
        rts
.empty  addq.l  #4,a0
        bra     .line_next
