        include "span.i"

; span_arbitrary - draws a scanline table from a map of any size
;
; like:    span_affine_swap
; in:      a0  span_plan*  the table, the frame, the map, its width, the steps
; reads:   the plan, its lines (start0 = uu, start1 = UU, start2 = VVvv), of the
;          map the texels shown and no byte more
; formats: u, v 16.16, inside the map at every pixel; any map address; width and
;          height up to 1024; 8-bit texels and pixels
; cost:    bench row arbitrary; if dvdx is whole, bench row arbitrary_row

; The texel's address moves by whole texels and rows, by 1 more when u's fraction
; carries, by a row more when v's does:
;       d0  uu--        d1  vv--        a4  texel
; The address moves after the fetch: after a line's last pixel it may be outside the
; map, but nothing is fetched there. OR, not AND, turns the carry into a row: in the
; emulator OR overlaps with the store, and AND does not.

pixel   macro
        move.b  (a4),(a1)+
        add.l   d4,d1
        subx.l  d6,d6                   ; -1 after v's carry, or 0
        or.l    d5,d6                   ; -1             or -1 - width
        add.l   d3,d0
        addx.l  d2,d6                   ; and width + 1, the whole steps, u's carry
        adda.l  d6,a4
        endm

; For a whole step of v: its fraction never carries.
pixel_row macro
        move.b  (a4),(a1)+
        add.l   d3,d0
        addx.l  d2,d1
        movea.l d1,a4
        endm

; a4 = the line's first texel, d1 = vvVV. Uses d6.
first_texel macro
        swap    d1
        move.w  d5,d6
        not.w   d6
        mulu.w  d1,d6
        add.l   4(sp),d6                ; map
        movea.l d6,a4
        adda.w  d0,a4
        endm

        span span_arbitrary
        span_open
        move.l  (sp),-(sp)
        move.l  span_plan_map(a0),4(sp)
        move.l  span_plan_dudx(a0),d3
        move.l  span_plan_dvdx(a0),d4
        move.l  span_plan_map_width(a0),d5
        span_table
        swap    d3                      ; uuUU
        swap    d4                      ; vvVV
        move.w  d4,d2
        muls.w  d5,d2
        movea.w d3,a2
        add.l   a2,d2                   ; whole steps: VV width + UU
        clr.w   d3                      ; uu--
        clr.w   d4                      ; vv--
        not.l   d5                      ; -1 - width
        tst.l   d4
        beq     rows
        sub.l   d5,d2
        lea     .pixels_end-14(pc),a3
        span_line d0,d1
        first_texel
        span_rounds 3
        span_enter 2,4
.pixels rept    8
        pixel
        endr
        span_close (sp),8

        cnop    0,4
rows    lea     .pixels_end-8(pc),a3
        span_line d0,d1
        first_texel
        move.l  a4,d1
        span_rounds 4
        jmp     (a3,d6.w*8)
.pixels rept    16
        pixel_row
        endr
        span_close (sp),8
