; The cost of memory accesses alone: the floor under every span.

        include "routine.i"

ACCESSES                equ     16      ; unrolled

accesses macro
.round  rept    ACCESSES
        \1
        endr
        dbra    d7,.round
        rts
        endm

fetch   macro
        move.b  (a0),d0
        endm

store   macro
        move.b  d0,(a1)+
        endm

copy    macro
        move.b  (a0),(a1)+
        endm

; floor_fetch - bytes fetched through an address register
;
; in:      a0  const uint8*  the byte
;          d7  int32   rounds of 16, less one
; out:     d0  uint8   the byte
; trashes: d7
        routine floor_fetch
        accesses fetch

; floor_store - bytes stored one after the other
;
; in:      a1  uint8*  the first byte's address
;          d0  uint8   the byte
;          d7  int32   rounds of 16, less one
; out:     a1  uint8*  after the last byte
; trashes: d7
; writes:  16 bytes a round
        routine floor_store
        accesses store

; floor_copy - a byte fetched and stored for each pixel
;
; in:      a0  const uint8*  the byte
;          a1  uint8*  the first copy's address
;          d7  int32   rounds of 16, less one
; out:     a1  uint8*  after the last byte
; trashes: d7
; writes:  16 bytes a round
        routine floor_copy
        accesses copy
