        include "n64.i"

; n64_walk - coordinates without perspective
;
; in:      a0  const n64_iterators*  s and t at the first pixel
;          a1  n64_coordinates*  coordinates
;          a2  const n64_iterators*  their steps
; formats: s15.16 modulo 2^32 to s:t, the upper words
        pass    n64_walk
        movem.l d2-d7,-(sp)
        n64_rounds
        movem.l (a0),d0-d1
        movem.l (a2),d2-d3
        n64_step
        movem.l (sp)+,d2-d7
        rts
