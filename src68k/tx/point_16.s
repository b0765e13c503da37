        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tx_point_16 - texels of two bytes by point sampling, for a 16-bit frame
;
; in:      a0  const tx_coordinates*  relative coordinates
;          a1  uint16*  texels, 5/5/5/1
;          a2  const tx_decoded*  the tile, texels of two bytes, 5/5/5/1
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the coordinates, the tile, its texels
; writes:  the texels
; formats: s:t, both s10.5 modulo 2^16
; error:   none
; cost:    bench row tx_point_16
;==============================================================================
        routine tx_point_16,a0,a1,a2,d0
        tx_sample w,2
