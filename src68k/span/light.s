        include "span.i"

; span_light - puts the pixels of a scanline table through one row of a light table
;
; in:      a0  span_plan*  the table, the frame, the row
; trashes: d0-d7/a0-a6
; reads:   the plan, left and last of its lines, their pixels and up to three before a
;          line, 256 bytes at light, a multiple of 256
; writes:  the pixels of the lines, nothing else
; formats: 8-bit chunky pixels
; error:   none: pixel p becomes light[p]

; From right to left, four pixels a longword: those of chip RAM are read a quarter as often.
; The first longword ends with the line, wherever it begins, and is entered after as many
; pixels as it has too many.

        span span_light
        span_open
        move.l  span_plan_light(a0),d1  ; lll0
        span_table
        move.l  (sp),d4
        moveq   #3,d5
        lea     .pixels_end-6(pc),a4    ; 8 bytes a pixel, the first 2 of them done
        span_line d0
        lea     1(a1,d7.w),a1           ; the line's end
        move.l  -4(a1),d0
        move.w  d5,d6
        and.w   d7,d6
        lea     -1(a1),a3
        suba.w  d6,a3                   ; the next longword's end
        span_rounds 4
        jmp     (a4,d6.w*8)
.pixels rept    4
        move.l  -(a3),d0
        move.b  d0,d1
        movea.l d1,a2
        move.b  (a2),-(a1)
        rept    3
        lsr.l   #8,d0
        move.b  d0,d1
        movea.l d1,a2
        move.b  (a2),-(a1)
        endr
        endr
        span_close d4
