;==============================================================================
; uaequit - the command that ends an FS-UAE session
;
; in:      a0  char*  its argument: the name of a file to write
;          d0  int32  the argument's length
; out:     -
; trashes: everything
; reads:   the return code of the command before it
; writes:  the file: "N", that return code. Its presence tells the host that
;          everything before was written.
; formats: -
; error:   where there is no UAE ($F0FF60 reads zero) it just returns
; cost:    -
;==============================================================================
; A command of its own, so that the programs stay ordinary Amiga programs. UAE
; answers at $F0FF60 to calls with a function number on the stack.

        include "amiga.i"

UAE_TRAP                equ     $f0ff60
UAE_EXIT                equ     13
MODE_NEWFILE            equ     1006
cli_ReturnCode          equ     12

        xdef    start
        section .text.start,code
start:
        lea     -1(a0,d0.l),a1          ; the argument ends in a line feed
        clr.b   (a1)
        movea.l a0,a3
        movea.l 4.w,a6
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a0
        move.l  pr_CLI(a0),d0
        lsl.l   #2,d0
        movea.l d0,a0
        moveq   #0,d0
        move.b  cli_ReturnCode+3(a0),d0
        divu.w  #10,d0                  ; two digits
        add.b   #'0',d0
        move.b  d0,d4
        lsl.w   #8,d4
        swap    d0
        add.b   #'0',d0
        move.b  d0,d4
        lea     .dos_name(pc),a1
        moveq   #36,d0
        lvo     OpenLibrary
        tst.l   d0
        beq.s   .exit
        movea.l d0,a6
        move.l  a3,d1
        move.l  #MODE_NEWFILE,d2
        lvo     Open
        move.l  d0,d5
        beq.s   .exit
        move.w  d4,-(sp)
        move.l  d5,d1
        move.l  sp,d2
        moveq   #2,d3
        lvo     Write
        addq.l  #2,sp
        move.l  d5,d1
        lvo     Close
.exit   tst.l   UAE_TRAP
        beq.s   .absent
        pea     UAE_EXIT
        jsr     UAE_TRAP
        addq.l  #4,sp
.absent moveq   #0,d0
        rts
.dos_name       dc.b    'dos.library',0
                even
