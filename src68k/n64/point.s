        include "n64.i"

;==============================================================================
; n64_point - texels by point sampling
;
; in:      a0  const n64_coordinates*  relative coordinates
;          a1  uint32*  texels, R G B A
;          a2  const n64_decoded*  the tile
; formats: s:t, both s10.5 modulo 2^16
;==============================================================================
        pass    n64_point
        n64_texels n64_decoded,5,d2.l*4
