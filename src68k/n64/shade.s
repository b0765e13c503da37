        include "routine.i"

; n64_shade - interpolated colours
;
; in:      a0  const n64_shades*  at the first pixel
;          a1  uint32*  colours, R G B A
;          a2  const n64_shades*  their steps
; formats: 16.16 modulo 2^32, signed; the integers clamped to 0 to 255

; Shifts the integer of \1, clamped, into d5 and steps \1 by \2. Uses d4; d6 is 255.
channel macro
        move.l  \1,d4
        swap    d4
        cmp.w   d6,d4
        bls.s   .inside\@
        tst.w   d4
        spl     d4
.inside\@
        lsl.l   #8,d5
        move.b  d4,d5
        add.l   \2,\1
        endm

        pass    n64_shade
        movem.l d2-d7/a2-a6,-(sp)
        move.l  d0,d7
        movem.l (a0),d0-d3
        movem.l (a2),a2-a5
        lea     (a1,d7.l*4),a6
        move.w  #255,d6
.pixels channel d0,a2
        channel d1,a3
        channel d2,a4
        channel d3,a5
        move.l  d5,(a1)+
        cmpa.l  a6,a1
        bne.s   .pixels
        movem.l (sp)+,d2-d7/a2-a6
        rts
