        include "span.i"

; span_affine_row - span_affine_addx if v's step is 0: floors, upright pictures
;
; like:    span_affine_addx
; in:      a0  span_plan*  the table, the frame, the map, the step dudx
; formats: u 8.16, V 8 bits; both wrap at 256; 8-bit texels and pixels. dudx is used
;          modulo 256, as -128 to 127.99: u moves 64,000 texels a line at most. dvdx
;          is 0 modulo 256 and not read
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v))

; A line's texels are in one row of the map: u alone, in a chain of one register.

        span span_affine_row
        alone_open dudx
        pack_alone d2,d5,a4
        move.l  (sp),d3
        lea     .pixels_end-8(pc),a3
        span_line d0,d1
        span_rounds 4
        move.w  d0,d4                   ; mmVv
        move.b  d1,d5
        move.w  d5,d0                   ; uu-U
        add.l   a4,d0
        jmp     (a3,d6.w*8)
.pixels rept    16
        pixel_row
        endr
        span_close d3
