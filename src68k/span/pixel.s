; A whole pixel with one, two and three interpolants, by swap and by addx: fetched
; from a row, fetched from a 256x256 map, fetched from it and lit through a table.

        include "chain.i"

; \1: how many in a round, \2: the pixel's code
pixels  macro
.round  rept    \1
        \2
        endr
        cmpa.l  a6,a1                   ; keeps X; dbra has no free register
        bne     .round
        rts
        endm

pixel_s1 macro
        move.l  d0,d4
        add.l   d2,d0
        swap    d4
        move.b  (a0,d4.w),(a1)+
        endm

pixel_a1 macro
        move.b  (a0,d0.w),(a1)+
        addx.l  d2,d0
        endm

pixel_s2 macro
        join_uv d7
        add.l   d2,d0
        add.l   d3,d1
        move.b  (a0,d4.w),(a1)+
        endm

pixel_s3 macro
        join_uv d7
        move.l  d5,d6                   ; Ccc-
        swap    d6                      ; c-Cc
        move.b  (a0,d4.w),d6            ; C and the texel
        add.l   d2,d0
        add.l   d3,d1
        add.l   a4,d5
        move.b  (a3,d6.w),(a1)+
        endm

; d0 uuVv, d1 c--U, d2 v-Cc: u carries into U, c's lower byte into Cc, v's into Vv.
pixel_a3 macro
        pixel_lit d0,d2
        endm

; pixel_swap_1 - one interpolant by swap
;
; in:      d0  uint32  u, UUuu
;          d2  uint32  dudx, UUuu
;          a0  uint8*  a row of texels
;          a1  uint8*  first pixel
;          a6  uint8*  after the last pixel
; out:     a1  uint8*  after the last pixel
; trashes: d0/d4
; reads:   the row
; writes:  the pixels, a multiple of 16
; formats: u 16.16, 0 to 32767
        routine pixel_swap_1
        pixels  16,pixel_s1

; pixel_addx_1 - one interpolant by addx, chained to itself
;
; like:    pixel_swap_1
; in:      d0  uint32  u, uuUU, the fraction one step ahead
;          d2  uint32  dudx, uuUU
; trashes: d0
; formats: u 16.16, 0 to 32767; u's carry enters U at the next pixel
; error:   none if u's first carry is in d0 already
        routine pixel_addx_1
        move    #0,ccr
        pixels  16,pixel_a1

; pixel_swap_2 - two interpolants by swap: the pixel of span_affine_swap
;
; like:    pixel_swap_1
; in:      d1  uint32  v + 128 rows, VVvv << 8
;          d2  uint32  dudx
;          d3  uint32  dvdx << 8
;          d7  uint32  $00ffffff
;          a0  uint8*  256x256 map + 32,768
; trashes: d0-d1/d4
; reads:   the map
; writes:  the pixels, a multiple of 8
; formats: u, v 8.16, both wrap
        routine pixel_swap_2
        pixels  8,pixel_s2

; pixel_addx_2 - two interpolants by addx: the pixel of span_affine_addx
;
; in:      d0  uint32  uuVv
;          d1  uint32  v--U, v one step ahead
;          d2  uint32  step, uuVv
;          d3  uint32  step, v--U
;          d4  uint32  256x256 map at a multiple of 65,536
;          a1  uint8*  first pixel
;          a6  uint8*  after the last pixel
; out:     a1  uint8*  after the last pixel
; trashes: d0-d1/d4/a2
; reads:   the map
; writes:  the pixels, a multiple of 16
; formats: u, v 8.16, both wrap, v once
; error:   none if v's first carry is in d0 already
        routine pixel_addx_2
        move    #0,ccr
        pixels  16,pixel_chain

; pixel_swap_3 - three interpolants by swap: u, v and a shade
;
; like:    pixel_swap_2
; in:      d5  uint32  shade + 128, CCcc << 8
;          a4  uint32  its step << 8
;          a3  uint8*  table of 256 shades by 256 texels + 32,768
; trashes: d0-d1/d4-d6
; reads:   the map, the table
; formats: u, v, shade 8.16
        routine pixel_swap_3
        pixels  8,pixel_s3

; pixel_addx_3 - three interpolants in one addx chain: u, v and a shade
;
; like:    pixel_addx_2
; in:      d1  uint32  c--U
;          d2  uint32  v-Cc, v one step ahead
;          d3  uint32  step, uuVv
;          d4  uint32  step, c--U
;          d5  uint32  step, v-Cc
;          d6  uint32  256x256 map at a multiple of 65,536
;          d7  uint32  table of shades at a multiple of 65,536
; trashes: d0-d2/d6-d7/a2
; reads:   the map, the table
; writes:  the pixels, a multiple of 8
; formats: u, v, shade 8.16; v wraps once
        routine pixel_addx_3
        move    #0,ccr
        pixels  8,pixel_a3
