        include "span.i"

; span_lit_gouraud - draws a scanline table from a 256x256 map, lit pixel by pixel
;
; in:      a0  span_plan*  the table, the frame, the map, the light, all steps
; trashes: d0-d7/a0-a6
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), their shades
;          (c-Cc, as edge_shade packs them for this dvdx), the map, the light table
; writes:  the pixels of the lines, nothing else
; formats: u, v 8.16, both wrap at 256 any number of times; levels 8.14, inside the
;          light table at every pixel; lines of 1024 pixels at most; 8-bit texels
; error:   none: pixel n shows light[256 floor(c + n dcdx) + the texel that
;          span_affine_addx shows]; dcdx's two lowest bits are ignored
; cost:    bench row affine_gouraud

; One circular carry chain over three registers:
;       B  uuCc   u's fraction, the level, the upper byte of its fraction
;       A  v--U   the lower byte of v's fraction, two spare bytes, U
;       D  c-Vv   six bits of the level's fraction, a spare byte, V, v's upper byte
; addx B takes D's carry (c) and gives its own (u) to addx A, which gives A's (v) to
; addx D. D's c is one step ahead. D's spare byte catches V's overflow: it is 00 if v
; rises, and FF if v falls: then D's lower part always carries, and the step of c is
; one less. Either fails once in 65,536 texels, at most twice in a line: the two bits
; below c are reserved for that, 0 if v rises and 3 if it falls.

        span span_lit_gouraud
        span_open
        move.l  span_plan_map(a0),d6    ; mm00
        move.l  span_plan_dudx(a0),d3
        move.l  span_plan_dvdx(a0),d2
        pack_uv d3,d2,d4                ; d3 uu--, d2 .Vv, d4 v--U
        move.l  span_plan_dcdx(a0),d1
        moveq   #0,d5
        and.b   #$fc,d1
        move.w  d2,d7
        ext.l   d7
        move.b  d1,d5
        ror.l   #8,d5                   ; c---
        lsr.l   #8,d1
        ext.l   d1                      ; Cc
        add_below d5,d7,d1,l            ; c-Vv
        add_below d3,d1,d4,b            ; uuCc
        ahead   d5,d2,a4,w              ; c-00
        move.l  span_plan_light(a0),d7
        clr.w   d7                      ; ll00
        movea.l span_plan_shades(a0),a3
        span_table
        move.l  a5,-(sp)
        movea.l a3,a5

        ; a line, without span_line: d6 and d7 keep their upper words
        bra.s   .line
.empty  addq.l  #4,a0
        addq.l  #4,a5
        bra     .line_next
.line   move.l  (a0)+,d0                ; uu:left
        move.w  d0,d6
        lea     (a6,d6.w),a1
        move.l  (a0)+,d1                ; last:Vv
        swap    d1
        sub.w   d6,d1
        bmi.s   .empty
        lea     1(a1,d1.w),a3           ; end of the line
        move.l  (a5)+,d2                ; c-Cc
        not.w   d1
        move.w  d2,d0                   ; uuCc
        and.w   #7,d1                   ; of the first round, not drawn
        move.w  d1,d6
        lsl.w   #2,d6
        add.w   d1,d6                   ; 20 bytes each
        swap    d1
        move.w  d1,d2                   ; c-Vv
        move.l  (a0)+,d1                ; v--U
        add.l   a4,d2
        jmp     .pixels(pc,d6.w*4)
.pixels rept    8
        pixel_lit d2,d0
        endr
        cmpa.l  a3,a1
        bne     .pixels
.line_next
        adda.l  4(sp),a6
        cmpa.l  (sp),a0
        bne     .line
        addq.l  #8,sp
        rts
