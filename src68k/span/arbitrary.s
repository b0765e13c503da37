        include "routine.i"
        include "layout.i"
        include "span.i"

; Steps without limits, by 7 instructions.
pixel_wide macro
        move.b  (a4),(a1)+
        add.l   d4,d1
        subx.l  d6,d6                   ; -1 after v's carry
        and.l   d5,d6
        add.l   d3,d0
        addx.l  d2,d6
        adda.l  d6,a4
        endm

pixel_row macro
        move.b  (a4),(a1)+
        add.l   d3,d0
        addx.l  d2,d1
        movea.l d1,a4
        endm

pixel_step macro
        move.b  (a4),(a1)+
        subx.w  d1,d1
        and.w   d2,d1
        addx.l  d3,d0
        addx.l  d4,d1
        \1.w    d1,a4
        endm
WIDE equ 1
ROUNDS equ 4

first_texel macro
        swap    d1                      ; vvVV
        move.w  d5,d6
        mulu.w  d1,d6
        add.l   4(sp),d6
        movea.l d6,a4
        adda.w  d0,a4
        endm

;==============================================================================
; span_arbitrary - draws a scanline table from a map of any size
;
; in:      a0  span_plan*  the table, the frame, the map, the steps
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the plan, its lines (start0 = uu, start1 = UU, start2 = VVvv), the map
; writes:  the pixels of the lines, nothing else
; formats: u, v 16.16, inside the map at every pixel
; error:   none: pixel n shows texel (floor(u + n dudx), floor(v + n dvdx))
; cost:    bench row arbitrary
;==============================================================================
        routine span_arbitrary,a0
        span_open
        move.l  (sp),-(sp)
        move.l  span_plan_map(a0),4(sp)
        move.l  span_plan_dudx(a0),d3
        move.l  span_plan_dvdx(a0),d4
        move.l  span_plan_map_width(a0),d5
        span_table
        move.l  d4,d2
        swap    d2
        move.w  d5,d6                   ; not 1024 * 64...
        muls.w  d6,d2
        move.l  d3,d0
        swap    d0
        ext.l   d0
        add.l   d0,d2                   ; A
        swap    d3
        clr.w   d3
        swap    d4
        clr.w   d4
        ifd     WIDE
        bra     wide
        endc
        tst.l   d4
        beq     row
        ifd     ROWX
        bra     row
        endc
        ; direction, test only: floor form where A >= 0
        move.l  d2,d1
        add.l   d5,d1
        move.w  d2,d4
        move.l  d5,d2
        ext.l   d2
        bra     plus

wide    lea     .pixels_end-14(pc),a3
        span_line d0,d1
        first_texel
        clr.w   d1
        span_rounds 3
        span_enter_14
.pixels rept    8
        pixel_wide
        endr
        span_close (sp),8

plus    lea     .pixels_end-12(pc),a3
        span_line d0,d1
        first_texel
        eor.l   d2,d1
        clr.w   d1
        span_rounds ROUNDS
        add.l   d4,d1
        span_enter_12
.pixels rept    1<<ROUNDS
        pixel_step adda
        endr
        span_close (sp),8

row     lea     .pixels_end-8(pc),a3
        span_line d0,d1
        first_texel
        span_rounds 4
        move.l  a4,d1
        jmp     (a3,d6.w*8)
.pixels rept    16
        pixel_row
        endr
        span_close (sp),8
