        include "routine.i"

; n64_widen - texels as inputs of the combiner
;
; in:      a0  const uint32*  texels, R G B A
;          a1  n64_wide*  the same
;          a2  void*  not read
; formats: 0 to 255
        pass    n64_widen
        movem.l d2-d4,-(sp)
        move.l  #$00ff00ff,d4
        move.w  d0,d3
        subq.w  #1,d3
.pixels move.l  (a0)+,d1
        move.l  d1,d0
        lsr.l   #8,d0
        and.l   d4,d0                   ; -R-B
        and.l   d4,d1                   ; -G-A
        move.w  d0,d2                   ; B
        swap    d1                      ; -A-G
        move.w  d1,d0
        move.w  d2,d1
        move.l  d0,(a1)+                ; -R-G
        swap    d1
        move.l  d1,(a1)+                ; -B-A
        dbra    d3,.pixels
        movem.l (sp)+,d2-d4
        rts
