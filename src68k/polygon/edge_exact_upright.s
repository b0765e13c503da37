        include "extent.i"

        xref    edge_exact_across

; edge_exact_upright - an exact edge whose lines are columns of the frame
;
; like:    edge_exact
; formats: as edge_exact, but where W is above 0, x is floor(A / H) + 1, with A not rounded
; error:   none: with these edges, columns cover the pixels that lines cover
; cost:    about 340 cycles

; Lines have pixels that lie on left and upper edges. An edge whose y grows with x is a left edge below its
; pixels and a right one above them: as a column's first pixel is its first behind the edge, so is the
; first behind its last pixel.
        routine edge_exact_upright
        extent
        tst.l   d4
        ble.s   .ceil
        move.w  d4,d0
        mulu.w  d1,d0
        move.w  d7,d2
        mulu.w  d5,d2
        add.w   d2,d0                   ; 2^16 A
        bne.s   .ceil
        jsr     edge_exact_across
        addq.l  #1,edge_error(a0)       ; as if A were one more
        bcc.s   .made
        addq.l  #1,edge_x(a0)
        move.l  edge_height(a0),d0
        neg.l   d0
        move.l  d0,edge_error(a0)
.made   rts
.ceil   jmp     edge_exact_across
