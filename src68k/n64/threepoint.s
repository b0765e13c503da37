        include "n64.i"

; n64_threepoint - texels by the three-point filter
;
; in:      a0  const n64_coordinates*  relative coordinates
;          a1  uint32*  texels, R G B A
;          a2  const n64_decoded*  the tile, with quads
; formats: s:t, both s10.5 modulo 2^16
        pass    n64_threepoint
        n64_filter n64_weights_table,n64_write,$00ff00ff
