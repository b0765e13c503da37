; The entries of every routine of this tree.
;
;       routine name[,reg1[,reg2...]]
;
; opens a section for the routine (so that the linker drops it if nothing calls it)
; and defines two entries:
;       _name   for C: copies its stack arguments to the registers named
;       name    for assembly: takes them in those registers
; C arguments are 32 bits each. Both entries keep d2-d7/a2-a6.
;
;       pass name
;
; does the same for a pass of a texture unit over a line's pixels: a0 its input, a1 its output, a2
; other data, d0 how many. Its entry for C saves a2 and calls the other entry, which is PASS_SAVED
; bytes behind it.
;
;       span name
;
; does the same for a routine that draws a scanline table: a0 its span_plan. The entry for assembly keeps
; no registers; it is SPAN_SAVED bytes behind C's, whose address is in kind_spans.

        ifnd    ROUTINE_I
ROUTINE_I equ   1

        include "layout.i"

; Opens the section and defines C's entry.
c_entry macro
        section .text.\1,code
        cnop    0,4
        xdef    _\1
        xdef    \1
_\1:
        endm

routine macro
        c_entry \1
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
\1:
        endm

pass    macro
        c_entry \1
        move.l  a2,-(sp)
        movea.l 8(sp),a0
        movea.l 12(sp),a1
        movea.l 16(sp),a2
        move.l  20(sp),d0
        bsr.s   \1
        movea.l (sp)+,a2
        rts
\1:
        ifne    \1-_\1-PASS_SAVED
        fail    PASS_SAVED is not the distance of both entries
        endc
        endm

PASS_SAVED      equ     24

span    macro
        c_entry \1
        movea.l 4(sp),a0
        save_all
        bsr.s   \1
        return_all
\1:
        ifne    \1-_\1-SPAN_SAVED
        fail    SPAN_SAVED is not the distance of both entries
        endc
        endm

SPAN_SAVED      equ     16

; A routine that needs most registers begins with save_all and ends with return_all.
save_all macro
        movem.l d2-d7/a2-a6,-(sp)
        endm

return_all macro
        movem.l (sp)+,d2-d7/a2-a6
        rts
        endm

; Executes the instructions \1 and \2 only if N is set, as it is after a negative result.
minus   macro
        bpl.s   .plus\@
        \1
        ifnb    \2
        \2
        endc
.plus\@
        endm

        endc
