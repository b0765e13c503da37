; The entries of every routine of this tree.
;
;       routine name[,reg1[,reg2...]]
;
; opens a section for the routine (so that the linker drops it if nothing calls it)
; and defines two entries:
;       _name   for C: copies its stack arguments to the registers named
;       name    for assembly: takes them in those registers
; C arguments are 32 bits each. Both entries keep d2-d7/a2-a6. If the third register is a2,
; the entry for C saves a2 and calls the other entry.

        ifnd    ROUTINE_I
ROUTINE_I equ   1

        include "layout.i"

routine macro
        section .text.\1,code
        cnop    0,4
        xdef    _\1
        xdef    \1
_\1:
        ifc     '\4','a2'
        move.l  a2,-(sp)
        movea.l 8(sp),\2
        movea.l 12(sp),\3
        movea.l 16(sp),a2
        move.l  20(sp),\5
        bsr     \1
        movea.l (sp)+,a2
        rts
        else
        ifnb    \2
        move.l  4(sp),\2
        endc
        ifnb    \3
        move.l  8(sp),\3
        endc
        ifnb    \4
        move.l  12(sp),\4
        endc
        ifnb    \5
        move.l  16(sp),\5
        endc
        endc
\1:
        endm

; A routine that needs most registers begins with save_all and ends with return_all.
save_all macro
        movem.l d2-d7/a2-a6,-(sp)
        endm

return_all macro
        movem.l (sp)+,d2-d7/a2-a6
        rts
        endm

        endc
