        include "n64.i"

; n64_threepoint_16 - texels by the three-point filter into a 16-bit frame
;
; like:    n64_threepoint
; in:      a1  uint16*  pixels, 5/5/5/1
; formats: s:t, both s10.5 modulo 2^16; channels >> 3, alpha >> 7
        pass    n64_threepoint_16
        n64_filter n64_weights_table,n64_write_16,$07c00400
