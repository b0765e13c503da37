        include "n64.i"

; n64_point - texels by point sampling
;
; like:    n64_threepoint
; in:      a2  const n64_decoded*  the tile
        pass    n64_point
        n64_texels n64_decoded,5,d2.l*4
