        include "amiga.i"

FIRST                   equ     32
LETTERS                 equ     96
ROWS                    equ     8

; font_read - the ROM font's characters 32 to 127, topaz of 8 rows
;
; in:      d0  uint8*  room for 96 of them, 8 bytes each from the top, the leftmost dot the
;                      highest bit
; out:     d0  int32   1, or 0: the ROM has none
; reads:   the font
; error:   the room of characters that the font lacks is unchanged
        routine font_read,d0
        movem.l d2-d6/a2-a3/a6,-(sp)
        movea.l d0,a3
        moveq   #0,d5
        movea.l sys_base,a6
        lea     .library(pc),a1
        moveq   #0,d0
        lvo     OpenLibrary
        move.l  d0,d6
        beq.s   .done
        movea.l d0,a6
        lea     attributes,a0
        lvo     OpenFont
        tst.l   d0
        beq.s   .closed
        movea.l d0,a2
        bsr.s   copy
        movea.l a2,a1
        lvo     CloseFont
        moveq   #1,d5
.closed movea.l d6,a1
        movea.l sys_base,a6
        lvo     CloseLibrary
.done   move.l  d5,d0
        movem.l (sp)+,d2-d6/a2-a3/a6
        rts
.library
        dc.b    'graphics.library',0
        even

; Copies the characters of font a2 to a3.
copy    moveq   #FIRST,d0
.letter move.w  d0,d1
        cmp.b   tf_LoChar(a2),d0
        blo.s   .lacks
        cmp.b   tf_HiChar(a2),d0
        bhi.s   .lacks
        sub.b   tf_LoChar(a2),d1
        movea.l tf_CharLoc(a2),a0
        moveq   #0,d2
        move.w  (a0,d1.w*4),d2          ; bits from the start of a row
        movea.l tf_CharData(a2),a0
        moveq   #ROWS-1,d3
        movea.l a3,a1
.row    bfextu  (a0){d2:8},d4
        move.b  d4,(a1)+
        adda.w  tf_Modulo(a2),a0
        dbra    d3,.row
.lacks  addq.l  #ROWS,a3
        addq.w  #1,d0
        cmp.w   #FIRST+LETTERS,d0
        bne.s   .letter
        rts

        section .data.font,data
attributes
        dc.l    font_name
        dc.w    ROWS
        dc.b    0,FPF_ROMFONT
font_name
        dc.b    'topaz.font',0
        even
