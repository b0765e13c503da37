        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tx_divide - coordinates with perspective
;
; in:      a0  const tx_iterators*  at the first pixel
;          a1  tx_coordinates*  coordinates
;          a2  const tx_division*  what they change by, the table of reciprocals
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the iterators, the table
; writes:  the coordinates
; formats: s15.16 modulo 2^32, their upper words divided; the results clamped to s10.5,
;          32,767 where w is not above 0
; error:   none
; cost:    bench row tx_divide
;==============================================================================
        routine tx_divide,a0,a1,a2,d0
        tx_divide_line .check
