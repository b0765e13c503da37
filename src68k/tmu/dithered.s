        include "routine.i"
        include "layout.i"
        include "chain.i"

;==============================================================================
; tmu_dithered - a line of a 256x256 8-bit map, points of which each second one is moved
;
; in:      a0  const tmu_texels*  u and v of the first pixel
;          a1  uint8*  pixels
;          a2  const tmu_dithering*  the map, what u and v change by
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   u and v, the steps, the map
; writes:  the pixels
; formats: 8.16, u wraps at 256; even leads from pixel 0 to 1, odd from 1 to 2
; error:   none, as long as v stays on the map; where it wraps, u moves by 1/65,536
; cost:    bench row tmu_dithered
;==============================================================================
; The chain of span_affine_addx with two steps in turn. As the lowest part of v runs one step
; ahead, its part of a step comes with the other step's u.

; As texel_next and draw with the steps \1 and \2. 12 bytes.
pixel   macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        addx.l  \1,d0
        addx.l  \2,d1
        movea.l d4,a2
        move.b  (a2),(a1)+
        endm

        routine tmu_dithered,a0,a1,a2,d0
        save_all
        move.l  d0,d7
        move.l  tmu_dithering_map(a2),d4        ; mm00
        movem.l tmu_dithering_odd(a2),d2/d5
        chain_steps                     ; d2 uuVv, d3 v--U, a4 v---
        movea.l d2,a3
        move.l  d3,d6
        movea.l a4,a5
        movem.l tmu_dithering_even(a2),d2/d5
        chain_steps
        move.l  a4,d0
        sub.l   d0,d3
        add.l   a5,d3
        sub.l   a5,d6
        add.l   d0,d6
        movem.l (a0),d0/d5
        pack_uv d0,d5,d1                ; uu--, -.Vv, v--U
        move.w  d5,d0
        move.l  a3,d5
        movea.l d7,a0
        neg.l   d7
        and.w   #15,d7                  ; pixels the first round lacks
        btst    #0,d7
        beq.s   .even
        exg     d2,d5
        exg     d3,d6
.even   lea     .pixels(pc,d7.w*4),a2
        lea     (a2,d7.w*8),a2
        move.l  a0,d7
        subq.l  #1,d7
        lsr.l   #4,d7
        add.l   a4,d1                   ; X
        jmp     (a2)
.pixels rept    8
        pixel   d2,d3
        pixel   d5,d6
        endr
        dbra    d7,.pixels
        return_all
