        include "span.i"

; The carry chain of span_tiled with 13 fraction bits and an index of up to 18 bits
; (T: column, U: texel in it, one letter a bit; here with 7 v_bits and 5 of T):
;       B  uuuuuuuuuuuuu oooooo... VVVVVVV --
;       A  vvvvvvvvvvvvv o...TTTTT ------- UU
; The gaps of a step (A's below T, B's two last bits) are ones; after each step all
; bits except fraction and integers are cleared. A's v is one step ahead.

FRACTION        equ     $fff80000

pixel_16 macro
        move.w  d0,d4
        or.w    d1,d4                   ; 0, TTTTTVVVVVVVUU
        addx.l  d2,d0
        addx.l  d3,d1
        and.l   d5,d0
        and.l   d6,d1
        move.\1 (a4,d4.l*\2),(a1)+
        endm

pixel_18 macro
        move.l  d0,d4
        or.l    d1,d4
        and.l   d7,d4
        addx.l  d2,d0
        addx.l  d3,d1
        and.l   d5,d0
        and.l   d6,d1
        move.\1 (a4,d4.l*\2),(a1)+
        endm

; Packs u (\1 = uu:UU) and v (\2 = VVvv) into B (\1) and A (\2). In: a3 v_bits, d5, d6
; masks of B and A. Uses d4, d7.
pack_16 macro
        move.l  a3,d7
        move.w  \1,d4
        lsl.w   d7,d4                   ; TTTTTUU-------
        moveq   #3,d7
        and.w   \1,d7
        or.w    d7,d4
        swap    \2                      ; vv:VV
        move.w  \2,\1
        lsl.w   #2,\1
        move.w  d4,\2
        and.l   d5,\1
        and.l   d6,\2
        endm

pack_18 macro
        move.l  a3,d7
        moveq   #0,d4
        move.w  \1,d4
        lsl.l   d7,d4
        moveq   #3,d7
        and.w   \1,d7
        or.w    d7,d4
        and.l   d6,d4
        and.l   #~FRACTION,d4
        swap    \2                      ; vv:VV
        moveq   #0,d7
        move.w  \2,d7
        lsl.l   #2,d7
        and.l   d5,d7
        and.l   #FRACTION,\1
        or.l    d7,\1
        and.l   #FRACTION,\2
        or.l    d4,\2
        endm

; The loop over the lines, for indices of \1 bits, texels and pixels of \2 = b or w,
; \3 bytes.
column_lines macro
        moveq   #0,d4
        swap    d2
        pack_\1 d2,d3
        addq.b  #3,d2
        move.l  d5,d4
        and.l   #~FRACTION,d4
        or.l    d4,d3
        moveq   #0,d4
        span_line d0,d1,*\3
        lea     \3(a1,d7.w*\3),a2       ; end of the line
        pack_\1 d0,d1
        move.w  a1,d4
        sub.w   a2,d4
        and.w   #7*\3,d4                ; of the first round, not drawn
        ifeq    \1-18
        move.w  d4,d7
        lsl.w   #3,d4
        add.w   d7,d4
        else
        lsl.w   #4-\3,d4
        endc
        move.l  d3,d7
        and.l   #FRACTION,d7
        add.l   d7,d1
        ifeq    \1-18
        move.l  #~FRACTION,d7
        jmp     .pixels(pc,d4.w*(2/\3))
        else
        jmp     .pixels(pc,d4.w*2)
        endc
.pixels rept    8
        pixel_\1 \2,\3
        endr
        cmpa.l  a2,a1
        bne     .pixels
        span_next (sp)
        endm

column_span macro
        span_open
        movea.l span_plan_map(a0),a4
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d3
        movea.l span_plan_columns(a0),a1
        movea.l column_layout_v_bits(a1),a3
        move.l  #FRACTION,d5
        move.l  d5,d6
        or.l    column_layout_v_mask(a1),d5
        move.l  column_layout_u_mask(a1),d4
        or.l    d4,d6
        span_table
        swap    d4
        tst.w   d4
        bne     columns_18_\1
        column_lines 16,\1,\2
columns_18_\1:
        column_lines 18,\1,\2
        endm

; span_columns - draws a scanline table from a map in columns 4 texels wide
;
; in:      a0  span_plan*  the table, the frame, the map, its layout, the steps
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start0 = uu, start1 = UU, start2 = VVvv), the map,
;          its column_layout
; writes:  the pixels of the lines, nothing else
; formats: u, v 16.16, both wrap at the map's sides; 8-bit texels and pixels
; error:   pixel n shows texel (floor((u8 + n du8) / 8192), the same of v), where
;          u8 = floor(u / 8) and so on: u and v are cut to 13 fraction bits
; cost:    bench row columns; maps of more than 65,536 texels 2 cycles a pixel more
;          (frame and map in chip RAM 8)
        span span_columns
        column_span b,1

; span_columns_16 - the same from 16-bit texels to a 16-bit frame
;
; like:    span_columns
; reads:   as span_columns; plan->row is 2 EDGE_BIAS bytes before its first pixel
; formats: as span_columns, with 16-bit texels and pixels
; cost:    bench row columns_16; maps of more than 65,536 texels 2 cycles a pixel more
;          (frame and map in chip RAM 8)
        span span_columns_16
        column_span w,2
