; Parts shared by the passes of Glide's texture unit (structs: c/glide/passes.h).

        include "n64.i"
        include "span.i"

; Sets what glide_weigh reads of the level in the struct \1 at a2.
glide_level macro
        xref    glide_weights_table
        move.l  \1_mask_s(a2),d6        ; and mask_t
        move.w  \1_columns_bits(a2),d5
        movea.l \1_quads(a2),a4
        move.l  #$000f000f,d4
        lea     glide_weights_table,a5
        endm

; Goes to the part of glide_weights for the next s:t at a0, which goes on at a3. Uses a2.
glide_weigh macro
        move.l  (a0)+,d0                ; s:t
        moveq   #0,d2
        move.l  d0,d1
        and.l   d6,d0
        and.l   d4,d1
        n64_index
        move.l  d1,d3
        lsr.l   #8,d3
        lsr.l   #4,d3
        or.w    d3,d1                   ; fs << 4 | ft
        move.w  (a5,d1.w*2),d1
        lea     (a4,d2.l*2),a2
        jmp     (a5,d1.w)
        endm

; Filters the texels of the d0 coordinates at a0 to a1, by the parts of glide_weights. \1: the macro
; that writes a texel, \2: its value of d7.
glide_filter macro
        save_all
        lea     (a0,d0.l*4),a6
        move.l  #\2,d7
        lea     .weighed(pc),a3
        glide_level glide_decoded
        bra.s   .coordinates
.weighed
        \1
        cmpa.l  a6,a0
        beq.s   .done
.coordinates
        glide_weigh
.done   return_all
        endm

; The same, each texel's channels times those of the texels at a6, by the table of products a2. \1:
; the macro that multiplies and writes. In: a2 const glide_times*.
glide_filter_times macro
        save_all
        lea     (a0,d0.l*4),a3
        move.l  a3,d7                   ; end
        movea.l glide_times_other(a2),a6
        move.l  glide_times_products(a2),-(sp)
        lea     .weighed(pc),a3
        glide_level glide_times
        bra.s   .coordinates
.weighed
        movea.l (sp),a2
        \1
        cmpa.l  d7,a0
        beq.s   .done
.coordinates
        glide_weigh
.done   addq.l  #4,sp
        return_all
        endm

; \2's byte = the product of the channel in the upper byte of \1's lower word and the one at a6.
glide_product macro
        move.b  (a6)+,\1
        move.b  (a2,\1.w),\2
        endm

; \2 = the last coordinate, the field \1 of the steps a2; 2^32 - 1 for a wrapped axis. Uses \3.
glide_last macro
        moveq   #0,\3
        move.w  \1(a2),\3
        addq.w  #1,\3
        subq.l  #1,\3
        move.l  \3,\2
        endm

; Writes s:t of the iterators d0 and d1, stepped by d2 and d3, from a1 up to a0: shifted right by
; d6, less d7, clamped to 0 to a3 (s) and 0 to a4 (t). glide_clamp_outside must follow the code
; after the loop. Uses d4-d5.
glide_clamp_pixels macro
.pixel  move.l  d0,d4
        asr.l   d6,d4
        add.l   d2,d0
        sub.l   d7,d4
        cmp.l   a3,d4
        bhi.s   .out_s
.s_in   move.l  d1,d5
        asr.l   d6,d5
        add.l   d3,d1
        sub.l   d7,d5
        cmp.l   a4,d5
        bhi.s   .out_t
.t_in   swap    d4
        move.w  d5,d4
        move.l  d4,(a1)+
        cmpa.l  a0,a1
        bne.s   .pixel
        endm

glide_clamp_outside macro
.out_s  tst.l   d4
        bmi.s   .low_s
        move.l  a3,d4
        bra.s   .s_in
.low_s  moveq   #0,d4
        bra.s   .s_in
.out_t  tst.l   d5
        bmi.s   .low_t
        move.l  a4,d5
        bra.s   .t_in
.low_t  moveq   #0,d5
        bra.s   .t_in
        endm

; Opens a pass over texels and others: a3 = others, d6 = bytes from one of them to the next, a4 =
; factors, a5 = bytes from one of them to the next, a6 = the texels' end, d5 = flip, d7 = 00ff00ff,
; a2 = one. In: a0, a2, d0.
glide_mix_open macro
        lea     (a0,d0.l*4),a6
        movea.l glide_mix_other(a2),a3
        movea.l glide_mix_factors(a2),a4
        move.l  glide_mix_other_step(a2),d6
        movea.l glide_mix_factor_step(a2),a5
        move.l  glide_mix_flip(a2),d5
        move.l  #$00ff00ff,d7
        movea.l glide_mix_one(a2),a2
        endm

; \1 = the pixel's factor.
glide_factor macro
        moveq   #0,\1
        move.b  (a4),\1
        adda.l  a5,a4
        eor.b   d5,\1
        add.l   a2,\1
        endm

; Writes the texel from d0 = R-B- and d3 = -G-A. Goes to .pixels; returns after the last one.
glide_mix_close macro
        eor.l   d0,d3
        and.l   d7,d3
        eor.l   d3,d0
        move.l  d0,(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        return_all
        endm

; Multiplies each byte x of d0's lower word by the same byte y of d1: x (y + 1) / 256, rounded down.
; d6 is 255. Uses d2-d4.
glide_products macro
        move.w  d0,d2
        move.w  d1,d3
        and.w   d6,d2
        and.w   d6,d3
        addq.w  #1,d3
        mulu.w  d3,d2
        move.w  d0,d3
        move.w  d1,d4
        lsr.w   #8,d3
        lsr.w   #8,d4
        addq.w  #1,d4
        mulu.w  d4,d3
        lsr.w   #8,d2
        move.b  d2,d3
        move.w  d3,d0
        endm

; Packs the coordinates \1 and \2, 8.24, into S, Q and P: \1 = uuu-, \3 = vv-U, \2's lower word =
; Vv. As pack_uv in chain.i does for 16.16, but v has 8 bits more. Coordinates were shifted left by
; 6 at least, so v's lowest 6 bits are 0: with the byte above U, 14 bits catch U's overflow.
pack_fine macro
        rol.l   #8,\1                   ; uuuU
        swap    \2                      ; vvVv
        move.l  \2,\3
        clr.w   \3
        move.b  \1,\3
        clr.b   \1
        endm

; Draws a line of d0 pixels, \1 bytes each, at a1: 16 a round, entered in its middle. d0, d4, d1 are
; S, Q and P, d2, d5, d3 their steps.
glide_paged macro
        movem.l d2-d7/a3,-(sp)
        move.l  d0,d7
        subq.l  #1,d7
        span_rounds_out 4
        movem.l glide_paging_s(a2),d2-d4 ; and left, in the upper word
        movea.l glide_paging_pixels(a2),a3
        movem.l (a0),d0-d1
        swap    d4
        lsl.l   d4,d0
        lsl.l   d4,d1
        lsl.l   d4,d2
        lsl.l   d4,d3
        pack_fine d0,d1,d4
        pack_fine d2,d3,d5
        lea     .pixels(pc,d6.w*2),a0
        lea     (a0,d6.w*4),a0
        jmp     (a0,d6.w*8)
.pixels rept    16
        move.w  d1,d6                   ; Vv
        move.b  d4,d6                   ; VU
        add.l   d2,d0
        addx.l  d5,d4
        addx.w  d3,d1
        ifeq    \1-2
        move.w  (a3,d6.w*2),(a1)+
        else
        move.l  (a3,d6.w*4),(a1)+
        endc
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7/a3
        rts
        endm

; Opens a loop at .pixels that multiplies texels d0 by others d1, which flip is applied to; d2-d4
; are free. glide_modulate_close ends it.
glide_modulate_open macro
        movem.l d2-d7/a2-a3,-(sp)
        lea     (a0,d0.l*4),a3
        move.l  glide_mix_flip(a2),d7
        move.l  glide_mix_other_step(a2),d5
        movea.l glide_mix_other(a2),a2
        move.w  #255,d6
.pixels move.l  (a0)+,d0
        move.l  (a2),d1
        adda.l  d5,a2
        eor.l   d7,d1
        endm

glide_modulate_close macro
        move.l  d0,(a1)+
        cmpa.l  a3,a0
        bne.s   .pixels
        movem.l (sp)+,d2-d7/a2-a3
        rts
        endm
