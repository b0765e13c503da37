        include "scissor.i"

start_flat macro
        endm

; scissor_flat - cuts a scanline table without u and v to the frame's columns
;
; in:      a0  scissor_plan*  the table and the frame's width
; reads:   the plan, left and last of its lines
; writes:  left and last of its lines
; formats: x with EDGE_BIAS, 0 to 32,769; of a line wholly outside last is below left
; cost:    about 45 cycles a line
        routine scissor_flat,a0
        scissor start_flat
