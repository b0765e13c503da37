; The program of one scene in which nothing moves: start, maps, frames, end. Its memory is cleared memory of the
; program's file, so that nothing is allocated.
        include "amiga.i"

        xdef    still_start,still_main
        xref    dos_base,still_head,_still_draw,still_calls,workbench_none

DOS_VERSION             equ     36      ; Kickstart 2.0: PrintFault
DIGITS                  equ     9       ; behind those of the file's name

; still_start - entry of the program, from a shell; a double click only replies and ends
;
; out:     d0  int32  AmigaDOS return code
; error:   no 68020 or no Kickstart 2.0: returns 20

; Up to still_main it runs on a 68000.
        section .text.still_start,code
still_start:
        movem.l d2-d7/a2-a6,-(sp)
        movea.l sys_base,a6
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a4
        tst.l   pr_CLI(a4)
        bne.s   .shell
        jmp     workbench_none
.shell  moveq   #RETURN_FAIL,d2
        btst    #AFB_68020,AttnFlags+1(a6)
        beq.s   .end
        lea     .dos(pc),a1
        moveq   #DOS_VERSION,d0
        lvo     OpenLibrary
        move.l  d0,dos_base
        beq.s   .end
        jsr     still_main
        move.l  d0,d2
        movea.l sys_base,a6
        movea.l dos_base,a1
        lvo     CloseLibrary
.end    move.l  d2,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts
.dos    dc.b    'dos.library',0
        even

; still_main - places the maps, draws all frames and saves each
;
; out:     d0  int32  return code: 0, 5 after Ctrl-C, 10 if a file cannot be written
; reads:   still_head and the lists behind it
; writes:  maps, frame, files
        section .text.still_main,code
still_main:
        movem.l d2-d7/a2-a6,-(sp)
        lea     still_head,a4
        movem.l (a4)+,d0-d3             ; frames, pixels, bytes, pages
        movem.l d0-d2,-(sp)
        add.l   #$ffff,d3
        clr.w   d3
.map    move.l  (a4)+,d0
        beq.s   .field
        movea.l d0,a0
        movea.l (a4)+,a1
        adda.l  d3,a1
        movem.w (a4)+,d1/d2/d4/d5       ; mask, longwords, repeats, rows
        moveq   #0,d6
.row    move.w  d1,d0
        and.w   d6,d0
        moveq   #1,d7
        add.w   d2,d7
        mulu.w  d7,d0
        lea     (a0,d0.l*4),a2
        move.w  d4,d7
.repeat movea.l a2,a3
        move.w  d2,d0
.long   move.l  (a3)+,(a1)+
        dbra    d0,.long
        dbra    d7,.repeat
        addq.w  #1,d6
        dbra    d5,.row
        bra.s   .map
.place  movea.l d0,a0
        add.l   d3,(a0)
.field  move.l  (a4)+,d0
        bne.s   .place
        movea.l a4,a0
        jsr     still_calls
        movem.l (sp)+,d4/d6/d7          ; frames, pixels, bytes
        movea.l dos_base,a6
.frame  jsr     _still_draw
        lea     still_name(pc),a2
        move.l  a2,d1
        move.l  #FILE_NEW,d2
        lvo     Open
        move.l  d0,d5
        beq.s   .closed
        move.l  d5,d1
        move.l  d6,d2
        move.l  d7,d3
        lvo     Write
        sub.l   d0,d3                   ; 0: all of it
        lvo     IoErr
        move.l  d0,d2
        move.l  d5,d1
        lvo     Close
        tst.l   d3
        bne.s   .delete
        lea     DIGITS(a2),a0
.digit  addq.b  #1,-(a0)
        cmpi.b  #'9',(a0)
        bls.s   .named
        move.b  #'0',(a0)
        bra.s   .digit
.named  subq.l  #1,d4
        beq.s   .done                   ; d4: return code 0
        moveq   #0,d0
        move.l  #SIGBREAKF_CTRL_C,d1
        movea.l sys_base,a6
        lvo     SetSignal
        movea.l dos_base,a6
        and.w   #SIGBREAKF_CTRL_C,d0
        beq.s   .frame
        move.l  #ERROR_BREAK,d1
        moveq   #0,d2
        moveq   #RETURN_WARN,d4
        bra.s   .say
.delete move.l  a2,d1
        lvo     DeleteFile
        move.l  d2,d0
        bra.s   .failed
.closed lvo     IoErr
.failed move.l  d0,d1
        move.l  a2,d2
        moveq   #RETURN_ERROR,d4
.say    lvo     PrintFault
.done   move.l  d4,d0
        movem.l (sp)+,d2-d7/a2-a6
        rts
still_name      dc.b    'frame_000.chunky',0
                even
