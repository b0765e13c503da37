; Converts texels to 16-bit pixels.

        include "routine.i"

; Packs the fields of the texel \1: R and G at the top of its upper word, B and A at the top of
; the lower word. d6, d7: the masks. Uses d2.
fields  macro
        move.l  \1,d2
        and.l   d6,\1                   ; R-B-
        and.l   d7,d2                   ; -G-A
        lsl.l   #3,d2
        or.l    d2,\1
        endm

; Converts one pixel.
fields_alone macro
        move.l  (a0)+,d0
        fields  d0
        move.w  d0,d2
        swap    d0
        lsr.w   d5,d2
        or.w    d2,d0
        move.w  d0,(a1)+
        endm

; Converts d0 texels at a0 to pixels at a1. \1: mask of R and B, \2: mask of G and A, \3: right
; shift of the lower word. Two pixels at a time, in aligned longwords.
fields_store macro
        movem.l d2-d7,-(sp)
        move.l  #\1,d6
        move.l  #\2,d7
        moveq   #\3,d5
        move.l  d0,d4
        move.w  a1,d1
        btst    #1,d1
        beq.s   .aligned
        fields_alone
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
        fields_alone
.done   movem.l (sp)+,d2-d7
        rts
        endm
