        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tmu_point - texels by point sampling
;
; in:      a0  const tmu_coordinates*  coordinates
;          a1  uint32*  texels, R G B A
;          a2  const tmu_decoded*  the level
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the coordinates, the level, its texels
; writes:  the texels
; formats: s:t, both 12.4 modulo 2^16
; error:   none
; cost:    bench row tmu_point
;==============================================================================
        routine tmu_point,a0,a1,a2,d0
        tx_texels tmu_decoded,2,d2.l
