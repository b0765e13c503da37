        include "routine.i"

; n64_narrow - the combiner's results as texels
;
; in:      a0  const n64_wide*  results
;          a1  uint32*  texels, R G B A
;          a2  void*  not read
; formats: -128 to 383, clamped to 0 to 255

; The next number, clamped, in \1. d4 = 255.
narrow  macro
        move.w  (a0)+,\1
        cmp.w   d4,\1
        bls.s   .fits\@
        tst.w   \1
        spl     \1                      ; only the word's lower byte is used
.fits\@
        endm

        pass    n64_narrow
        movem.l d2-d5,-(sp)
        move.w  #255,d4
        move.w  d0,d5
        subq.w  #1,d5
.pixels narrow  d0
        narrow  d1
        narrow  d2
        narrow  d3
        lsl.w   #8,d0
        lsl.w   #8,d2
        move.b  d1,d0
        move.b  d3,d2
        swap    d0
        move.w  d2,d0
        move.l  d0,(a1)+
        dbra    d5,.pixels
        movem.l (sp)+,d2-d5
        rts
