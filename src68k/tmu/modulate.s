        include "routine.i"
        include "layout.i"
        include "tmu.i"

;==============================================================================
; tmu_modulate - texels times others, channel by channel
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint32*  texels, they may be the same memory
;          a2  const tmu_mix*  the others; flip
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   both
; writes:  the texels
; formats: m = other, inverted by flip: texel * (m + 1) >> 8
; error:   none
; cost:    bench row tmu_modulate
;==============================================================================
        routine tmu_modulate,a0,a1,a2,d0
        tmu_modulate_open
        tmu_products
        swap    d0
        swap    d1
        tmu_products
        swap    d0
        tmu_modulate_close
