        include "routine.i"

;==============================================================================
; tx_store_16 - texels into a 16-bit frame
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint16*  pixels, 5/5/5/1
;          a2  void*  not read
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the texels
; writes:  the pixels
; formats: channels >> 3, alpha >> 7
; error:   none
; cost:    bench row tx_store_16
;==============================================================================
; Two pixels at a time, longwords at even addresses of longwords.

; \1 = the fields of the texel \1, R and G on top of its upper word, B and A on top of
; the lower one. Uses d2.
fields  macro
        move.l  \1,d2
        and.l   d6,\1                   ; R-B-
        and.l   d7,d2                   ; -G-A
        lsl.l   #3,d2
        or.l    d2,\1
        endm

; A pixel alone.
alone   macro
        move.l  (a0)+,d0
        fields  d0
        move.w  d0,d2
        swap    d0
        lsr.w   d5,d2
        or.w    d2,d0
        move.w  d0,(a1)+
        endm

        routine tx_store_16,a0,a1,a2,d0
        movem.l d2-d7,-(sp)
        move.l  #$f800f800,d6
        move.l  #$00f80080,d7
        moveq   #10,d5
        move.l  d0,d4
        move.w  a1,d1
        btst    #1,d1
        beq.s   .aligned
        alone
        subq.l  #1,d4
.aligned
        move.l  d4,d3
        lsr.l   #1,d3
        bra     .next
.pair   move.l  (a0)+,d0
        fields  d0
        move.l  (a0)+,d1
        fields  d1
        swap    d0                      ; BA RG of the first
        move.w  d0,d2
        move.w  d1,d0                   ; BA of both
        move.w  d2,d1
        swap    d1                      ; RG of both
        lsr.l   d5,d0
        or.l    d0,d1
        move.l  d1,(a1)+
.next   dbra    d3,.pair
        lsr.l   #1,d4
        bcc.s   .done
        alone
.done   movem.l (sp)+,d2-d7
        rts
