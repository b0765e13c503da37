        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tx_walk - coordinates without perspective
;
; in:      a0  const tx_iterators*  s and t at the first pixel
;          a1  tx_coordinates*  coordinates
;          a2  const tx_iterators*  what they change by
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   s and t
; writes:  the coordinates
; formats: s15.16 modulo 2^32 to s:t, the upper words
; error:   none
; cost:    bench row tx_walk
;==============================================================================
; s is SSss, t swapped, so that its word is where it is wanted: ttTT.

        routine tx_walk,a0,a1,a2,d0
        movem.l d2-d7,-(sp)
        tx_rounds
        movem.l (a0),d0-d1
        movem.l (a2),d2-d3
        swap    d1
        move.l  d3,d5
        swap    d5                      ; --TT
        swap    d3
        clr.w   d3                      ; tt--
        lea     .pixels(pc,d6.l*4),a0
        jmp     (a0,d6.l*8)
.pixels rept    8
        move.l  d0,d4                   ; 12 bytes
        move.w  d1,d4
        add.l   d2,d0
        add.l   d3,d1
        addx.w  d5,d1
        move.l  d4,(a1)+
        endr
        dbra    d7,.pixels
        movem.l (sp)+,d2-d7
        rts
