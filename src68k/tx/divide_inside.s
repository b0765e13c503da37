        include "routine.i"
        include "layout.i"
        include "tx.i"

;==============================================================================
; tx_divide_inside - coordinates with perspective that stay in their range
;
; in:      a0  const tx_iterators*  at the first pixel
;          a1  tx_coordinates*  coordinates
;          a2  const tx_division*  what they change by, the table of reciprocals
;          d0  int32  count
; out:     -
; trashes: d0-d1/a0-a1
; reads:   the iterators, the table
; writes:  the coordinates
; formats: as tx_divide, with w above 0 and s and t from -1024 to 1023.97 at all pixels
; error:   none
; cost:    bench row tx_divide_inside
;==============================================================================
        routine tx_divide_inside,a0,a1,a2,d0
        tx_divide_line
