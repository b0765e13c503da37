; The entry of a program without a C library, and save() to keep what it made. Link it first:
; AmigaDOS enters a program at its first byte.

        xref    _main
        xdef    start
        xdef    save
        xdef    _save

_LVOForbid              equ     -132
_LVOFindTask            equ     -294
_LVOGetMsg              equ     -372
_LVOReplyMsg            equ     -378
_LVOWaitPort            equ     -384
_LVOCloseLibrary        equ     -414
_LVOOpenLibrary         equ     -552
_LVOOpen                equ     -30
_LVOClose               equ     -36
_LVOWrite               equ     -48
pr_MsgPort              equ     92
pr_CLI                  equ     172
MODE_NEWFILE            equ     1006
RETURN_FAIL             equ     20

;==============================================================================
; start - calls int main(void), whose result is the program's
;
; out:     d0  int32  AmigaDOS return code; 20 where it cannot run
; error:   it is for the Shell: started from Workbench it leaves at once
;==============================================================================
        section .text,code
start:
        movem.l d2-d7/a2-a6,-(sp)
        movea.l 4.w,a6
        suba.l  a1,a1
        jsr     _LVOFindTask(a6)
        movea.l d0,a4
        tst.l   pr_CLI(a4)
        bne.s   .shell
        lea     pr_MsgPort(a4),a0
        jsr     _LVOWaitPort(a6)
        lea     pr_MsgPort(a4),a0
        jsr     _LVOGetMsg(a6)
        move.l  d0,d2
        jsr     _LVOForbid(a6)          ; until this code is unloaded
        movea.l d2,a1
        jsr     _LVOReplyMsg(a6)
        bra.s   .fail
.shell  lea     .dos(pc),a1
        moveq   #36,d0
        jsr     _LVOOpenLibrary(a6)
        move.l  d0,dos_base
        beq.s   .fail
        jsr     _main
        move.l  d0,d2
        movea.l 4.w,a6
        movea.l dos_base,a1
        jsr     _LVOCloseLibrary(a6)
        move.l  d2,d0
        bra.s   .end
.fail   moveq   #RETURN_FAIL,d0
.end    movem.l (sp)+,d2-d7/a2-a6
        rts
.dos    dc.b    'dos.library',0
        even

;==============================================================================
; save - writes a file
;
; in:      d0  const char*  its name
;          d1  const void*  what goes into it
;          a0  int32        bytes
; out:     d0  int32        1 written, 0 not
; reads:   the bytes
; writes:  the file
; error:   a file that could not be written whole stays as it is
;==============================================================================
        cnop    0,4
_save:
        move.l  4(sp),d0
        move.l  8(sp),d1
        movea.l 12(sp),a0
save:
        movem.l d2-d5/a6,-(sp)
        move.l  d1,d4
        move.l  a0,d5
        move.l  d0,d1
        move.l  #MODE_NEWFILE,d2
        movea.l dos_base,a6
        jsr     _LVOOpen(a6)
        move.l  d0,d1
        beq.s   .end
        move.l  d4,d2
        move.l  d5,d3
        move.l  d1,d4
        jsr     _LVOWrite(a6)
        sub.l   d0,d5
        move.l  d4,d1
        jsr     _LVOClose(a6)
        moveq   #1,d0
        tst.l   d5
        beq.s   .end
        moveq   #0,d0
.end    movem.l (sp)+,d2-d5/a6
        rts

        section .bss,bss
dos_base ds.l   1
