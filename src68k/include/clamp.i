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

; Clamps the start \1 of a line of d6 + 1 pixels with the step \2, so that it and the line's end
; are within [\3, \4]. Uses d1-d2.
clamp_line macro
        move.l  \2,d1
        muls.l  d6,d1
        move.l  \3,d2
        tst.l   d1
        bpl.s   .rises\@
        sub.l   d1,d2                   ; lowest start
        cmp.l   d2,\1
        bge.s   .above\@
        move.l  d2,\1
.above\@
        cmp.l   \4,\1
        ble.s   .held\@
        move.l  \4,\1
        bra.s   .held\@
.rises\@
        cmp.l   d2,\1
        bge.s   .first\@
        move.l  d2,\1
.first\@
        move.l  \4,d2
        sub.l   d1,d2                   ; highest start
        cmp.l   d2,\1
        ble.s   .held\@
        move.l  d2,\1
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
