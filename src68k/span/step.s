; One step of one, two and three interpolants by add and swap, by add and addx and
; by a circular chain of addx, with the integer part ready in a register's low word.
; Nothing else: the cost of the step before anything is drawn.

        include "routine.i"

STEPS                   equ     16      ; unrolled

; \1: the steps' code
steps   macro
.round  rept    STEPS
        \1
        endr
        dbra    d7,.round
        rts
        endm

swap_1  macro
        add.l   d3,d0
        move.l  d0,d6
        swap    d6
        endm

swap_2  macro
        swap_1
        add.l   d4,d1
        move.l  d1,d6
        swap    d6
        endm

swap_3  macro
        swap_2
        add.l   d5,d2
        move.l  d2,d6
        swap    d6
        endm

addx_1  macro
        add.l   d3,d0
        addx.w  d6,d0
        endm

addx_2  macro
        addx_1
        add.l   d4,d1
        addx.w  d6,d1
        endm

addx_3  macro
        addx_2
        add.l   d5,d2
        addx.w  d6,d2
        endm

; Each register holds a fraction above the integer of the one before it in the
; circle, so that every carry is where the next addx needs it.
chain_1 macro
        addx.l  d3,d0
        endm

chain_2 macro
        addx.l  d3,d0
        addx.l  d4,d1
        endm

chain_3 macro
        addx.l  d3,d0
        addx.l  d4,d1
        addx.l  d5,d2
        endm

; step_swap_1 - one interpolant by add and swap
;
; in:      d0  uint32  value, 16.16, ii:ff
;          d3  uint32  step, 16.16, ii:ff
;          d7  int32   rounds of 16 steps, less one
; out:     d0  uint32  value after the steps
; trashes: d6-d7
; formats: 16.16; the integer is taken to d6's low word
        routine step_swap_1
        steps   swap_1

; step_swap_2 - two interpolants by add and swap
;
; like:    step_swap_1
; in:      d1  uint32  value, 16.16, ii:ff
;          d4  uint32  step, 16.16, ii:ff
; out:     d1  uint32  value after the steps
        routine step_swap_2
        steps   swap_2

; step_swap_3 - three interpolants by add and swap
;
; like:    step_swap_2
; in:      d2  uint32  value, 16.16, ii:ff
;          d5  uint32  step, 16.16, ii:ff
; out:     d2  uint32  value after the steps
        routine step_swap_3
        steps   swap_3

; step_addx_1 - one interpolant by add and addx
;
; like:    step_chain_1
; in:      d6  uint32  0
; formats: integer in the low word, positive and below 32,768
; error:   none
        routine step_addx_1
        steps   addx_1

; step_addx_2 - two interpolants by add and addx
;
; like:    step_addx_1
; in:      d1  uint32  value, swapped, ff:ii
;          d4  uint32  step, swapped, ff:ii
; out:     d1  uint32  value after the steps
        routine step_addx_2
        steps   addx_2

; step_addx_3 - three interpolants by add and addx
;
; like:    step_addx_2
; in:      d2  uint32  value, swapped, ff:ii
;          d5  uint32  step, swapped, ff:ii
; out:     d2  uint32  value after the steps
        routine step_addx_3
        steps   addx_3

; step_chain_1 - one interpolant by a chain of addx
;
; in:      d0  uint32  value, swapped, ff:ii
;          d3  uint32  step, swapped, ff:ii
;          d7  int32   rounds of 16 steps, less one
; out:     d0  uint32  value after the steps
; trashes: d7
; formats: as addx; the upper word's fraction belongs to the integer of the
;          next register of the circle: d0 and again
; error:   none, but the last register's carry comes one step late; X is clear
;          at the start
        routine step_chain_1
        move    #0,ccr
        steps   chain_1

; step_chain_2 - two interpolants by a chain of addx
;
; like:    step_chain_1
; in:      d1  uint32  value, swapped, ff:ii
;          d4  uint32  step, swapped, ff:ii
; out:     d1  uint32  value after the steps
; formats: as addx; the upper word's fraction belongs to the integer of the
;          next register of the circle: d0, d1 and again
        routine step_chain_2
        move    #0,ccr
        steps   chain_2

; step_chain_3 - three interpolants by a chain of addx
;
; like:    step_chain_2
; in:      d2  uint32  value, swapped, ff:ii
;          d5  uint32  step, swapped, ff:ii
; out:     d2  uint32  value after the steps
; formats: as addx; the upper word's fraction belongs to the integer of the
;          next register of the circle: d0, d1, d2 and again
        routine step_chain_3
        move    #0,ccr
        steps   chain_3
