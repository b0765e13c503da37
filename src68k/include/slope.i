; The slope \1 (16.16) in swapped form, ff:ii, where adding it to a biased x gives
; the fraction's carry in C and X. A borrow is taken from the fraction for
; a negative integer; where the fraction is 0 it is counted as a whole pixel, so
; that the borrow never hides the carry. \2: the integer that goes with it.
swapped_slope macro
        move.l  \1,\2
        swap    \2
        ext.l   \2
        bpl.s   .whole\@
        tst.w   \1
        bne.s   .whole\@
        subq.l  #1,\2
.whole\@
        swap    \1
        clr.w   \1
        add.l   \2,\1
        endm
