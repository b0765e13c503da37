        include "span.i"
        include "amiga.i"

TO_PIXEL        equ     $132a           ; move.b d16(a2),-(a1)
RETURN          equ     $4ed3           ; jmp (a3)

; span_generated - draws a scanline table by code written for the polygon's steps
;
; in:      a0  span_plan*  the table, the frame, the map, the steps, the code
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start1 = UU, start2 = VVvv), the map with its
;          margins (MAP_MARGINS, texel (0, 0) at a multiple of 65536)
; writes:  the pixels of the lines; of the code, 4 bytes for each pixel of the longest
;          line (their number rounded up to a multiple of 8), and 2 after them
; formats: u, v 16.16, both wrap at 256; lines of 1024 pixels at most
; error:   u and v are less than 1 texel too low, as the fractions of the line's start
;          are dropped, or too high by B = GENERATED_BIAS / 65536 at most. B exceeds the
;          rounding error of 1023 steps: in a line that starts on a texel's border, a
;          texel shows too early if it is 2 B away, but never late.
;          Pixel n is fetched 256 floor(B + n dvdx) + floor(B + n dudx) bytes, modulo
;          65536, from the first one's texel: if u leaves 0 to 255 inside a line, the
;          texels after that are from a neighbouring row. polygon_draw draws polygons with
;          such lines by the affine spans (c/drawing/generated.c)
; cost:    bench row generated, with the writing of the code and CacheClearU (exec)
;          once a table; bench row generated_once: one line of 1024 pixels. 4 bytes
;          of code a pixel: the instruction cache does not hold lines above 64 pixels

; The code ends with pixel 0, so that a line of n pixels is its last n instructions:
; it needs no patch, and the cache is flushed once a polygon.
; Writing it: d0 uu--, d1 vv--, d4 opcode:offset. V's carry becomes 256 or 0 below
; uu, where the step adds the integers; u's carry goes into the offset. The sum
; below uu must not carry: from a step of -256 on, v runs the other way (-v, -256).

        span span_generated
        span_open
        move.l  a0,-(sp)
        movea.l a5,a0
        moveq   #0,d7                   ; pixels of the longest line
.longer move.w  scanline_last(a0),d1
        sub.w   scanline_left(a0),d1
        addq.w  #1,d1
        cmp.w   d1,d7
        bge.s   .shorter
        move.w  d1,d7
.shorter
        lea     scanline_sizeof(a0),a0
        subq.l  #1,d0
        bne.s   .longer
        movea.l (sp),a0
        tst.w   d7
        beq     .done

        move.l  span_plan_dudx(a0),d3
        move.l  span_plan_dvdx(a0),d5
        move.l  d5,d6
        swap    d6
        lsl.w   #8,d6
        swap    d3                      ; uuUU
        add.w   d6,d3                   ; uu:step
        swap    d5
        clr.w   d5                      ; vv--
        move.l  #GENERATED_BIAS<<16,d0
        move.l  d0,d1
        move.w  #255,d2                 ; with X: 256
        cmp.w   #-256,d3
        blo.s   .forward
        neg.l   d5
        beq.s   .forward                ; v never carries: B is below 1
        not.l   d1
        clr.w   d1                      ; from -B less 1/65536 on v carries at the same pixels
        add.w   #256,d3
        move.w  #-257,d2
.forward
        movea.l span_plan_code(a0),a1
        lea     CODE_BYTES-4(a1),a1
        move.w  #RETURN,(a1)
        move.l  #TO_PIXEL<<16,d4
        subq.w  #1,d7
        lsr.w   #3,d7
.write  rept    8
        move.l  d4,-(a1)
        add.l   d5,d1
        subx.w  d0,d0                   ; uu:-1 after v's carry
        and.w   d2,d0
        addx.l  d3,d0
        addx.w  d0,d4
        endr
        dbra    d7,.write
        movea.l 4.w,a6
        lvo     CacheClearU
.done   movea.l (sp)+,a0
        movea.l span_plan_row(a0),a6
        movea.l span_plan_code(a0),a4
        lea     CODE_BYTES-4(a4),a4
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_count(a0),d0
        move.l  (sp),d5
        lea     .line_next(pc),a3
        span_table
        span_line d0,d1
        lsr.l   #8,d1
        move.w  d1,d4
        move.b  d0,d4                   ; mmVU
        movea.l d4,a2
        lea     1(a1,d7.w),a1
        not.w   d7
        jmp     (a4,d7.w*4)
        span_next d5
