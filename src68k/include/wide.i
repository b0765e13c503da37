; Whole spans of texels and pixels of \1 = 2 or 4 bytes.

        include "span.i"

; The chain of two registers, ...
wide_chain macro
        chain_open
        movea.l d4,a3
        span_line d0,d1,*\1
        span_rounds_out 4
        add.l   a4,d1
        span_enter_out 4
.pixels rept    16
        texel_next d2,d3
        draw_wide \1
        endr
        span_close d5,0
        endm

; ... S, Q and P apart, ...
wide_apart macro
        apart_open
        movea.l d4,a3
        span_line d0,d1,*\1
        apart_start
        span_rounds_out 4
        span_enter_out 2,4
.pixels rept    16
        texel_next_apart d2,d3
        draw_wide \1
        endr
        span_close (sp)
        endm

; ... these and the chain with separate steps for each line, ...
wide_scanline macro
        level_open a3
        span_line d0,d1,*\1
        movea.l (sp),a2
        move.l  (a2)+,d5
        move.l  (a2),d2
        apart_steps
        apart_start
        span_rounds_out 3
        span_enter_out 2,4
.pixels rept    8
        texel_next_apart d2,d3
        draw_wide \1
        endr
        level_next
        endm

wide_level macro
        level_open a3
        span_line d0,d1,*\1
        level_steps
        span_rounds_out 4
        add.l   a4,d1
        span_enter_out 4
.pixels rept    16
        texel_next d2,d3
        draw_wide \1
        endr
        level_next
        endm

; ... and u alone.
wide_row macro
        alone_open dudx
        movea.l d4,a3
        pack_alone d2,d5,a4
        move.l  (sp),d3
        span_line d0,d1,*\1
        span_rounds_out 4
        move.w  d0,d4                   ; Vv
        move.b  d1,d5
        move.w  d5,d0                   ; uu-U
        add.l   a4,d0
        jmp     .pixels(pc,d6.w*8)
.pixels rept    16
        move.b  d0,d4                   ; VU
        addx.l  d2,d0
        draw_wide \1
        endr
        span_close d3
        endm
