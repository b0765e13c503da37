; Keeping interpolants in their ranges, line by line.

        include "routine.i"

; d7 = pixels of the longest line of the table a4 (d6 lines), less one. Goes to \1 if that
; is 0. Uses d0.
longest_line macro
        moveq   #0,d7
.longer move.w  scanline_last(a4),d0
        sub.w   scanline_left(a4),d0
        cmp.w   d0,d7
        bge.s   .shorter
        move.w  d0,d7
.shorter
        lea     scanline_sizeof(a4),a4
        subq.l  #1,d6
        bne.s   .longer
        tst.l   d7
        beq.s   \1
        endm

; d6 = pixels of the line a4, less one. Goes to \1 if it is empty.
line_length macro
        move.w  scanline_last(a4),d6
        sub.w   scanline_left(a4),d6
        blt.s   \1
        ext.l   d6
        endm

; Holds the start \1 (see hold) of a line of d6 + 1 pixels with the step \2. Uses d1-d2.
hold_line macro
        move.l  \2,d1
        muls.l  d6,d1
        hold    \1,d1,d2,\3,\4
        endm

; Clamps the start \1 so that it and the line's end, \1 + \2, are within [\4, \5]. Uses
; \3.
hold    macro
        move.l  \4,\3
        tst.l   \2
        bpl.s   .rises\@
        sub.l   \2,\3                   ; lowest start
        cmp.l   \3,\1
        bge.s   .above\@
        move.l  \3,\1
.above\@
        cmp.l   \5,\1
        ble.s   .held\@
        move.l  \5,\1
        bra.s   .held\@
.rises\@
        cmp.l   \3,\1
        bge.s   .first\@
        move.l  \3,\1
.first\@
        move.l  \5,\3
        sub.l   \2,\3                   ; highest start
        cmp.l   \3,\1
        ble.s   .held\@
        move.l  \3,\1
.held\@
        endm

; Limits the step \1 (memory) so that d7 steps cover at most the range from \2 to \3
; (memory). \4: mask for the lowest byte of the limit, if given. Uses d0-d2.
limit   macro
        move.l  \3,d0
        sub.l   \2,d0
        divu.l  d7,d0                   ; the largest step
        ifnb    \4
        and.b   #\4,d0
        endc
        move.l  \1,d1
        move.l  d1,d2
        minus   <neg.l d2>
        cmp.l   d0,d2
        bls.s   .small\@
        tst.l   d1
        minus   <neg.l d0>
        move.l  d0,\1
.small\@
        endm
