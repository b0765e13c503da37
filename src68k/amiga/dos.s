; Files, console text and arguments, through dos. Files that a program opens are
; noted here and closed when it ends.

        include "amiga.i"

        xref    dos_base,no_arguments
        xdef    file_close_all,read_args

FILES                   equ     8

; Calls \1, Read or Write, for the handle d0, the address d1 and a0 bytes.
transfer macro
        movem.l d2/d3/a6,-(sp)
        move.l  d1,d2
        move.l  a0,d3
        lea     files,a0
        move.l  -4(a0,d0.l*4),d1
        movea.l dos_base,a6
        lvo     \1
        movem.l (sp)+,d2/d3/a6
        rts
        endm

; file_open - opens a file
;
; in:      d0  const char*  name, zero-terminated
;          d1  int32  mode: 1005 old file for reading, 1006 new file
; out:     d0  int32  handle 1 to 8, or 0: not opened
; writes:  the table of open files
; error:   also 0 if 8 files are open
        routine file_open,d0,d1
        movem.l d2/d3/a6,-(sp)
        move.l  d1,d2
        lea     files,a0
        moveq   #0,d3
.slot   addq.l  #1,d3
        tst.l   (a0)+
        beq.s   .free
        cmp.w   #FILES,d3
        bne.s   .slot
        moveq   #0,d3
        bra.s   .done
.free   move.l  a0,-(sp)
        move.l  d0,d1
        movea.l dos_base,a6
        lvo     Open
        movea.l (sp)+,a0
        move.l  d0,-(a0)
        bne.s   .done
        moveq   #0,d3
.done   move.l  d3,d0
        movem.l (sp)+,d2/d3/a6
        rts

; file_read - reads from an open file
;
; in:      d0  int32  handle from file_open
;          d1  void*  destination
;          a0  int32  bytes
; out:     d0  int32  bytes read, or -1
; error:   fewer bytes than requested at the file's end
        routine file_read,d0,d1,a0
        transfer Read

; file_write - writes to an open file
;
; in:      d0  int32  handle from file_open
;          d1  const void*  data
;          a0  int32  bytes
; out:     d0  int32  bytes written, or -1
; error:   fewer bytes than requested when the volume is full
        routine file_write,d0,d1,a0
        transfer Write

; file_size - length of an open file; its position returns to the start
;
; in:      d0  int32  handle from file_open
; out:     d0  int32  bytes
; error:   -1 if the file system does not know it
        routine file_size,d0
        movem.l d2/d3/d4/a6,-(sp)
        lea     files,a0
        move.l  -4(a0,d0.l*4),d4
        movea.l dos_base,a6
        move.l  d4,d1
        moveq   #0,d2
        moveq   #1,d3                   ; to the end
        lvo     Seek
        move.l  d4,d1
        moveq   #0,d2
        moveq   #-1,d3                  ; to the start, gives the old position
        lvo     Seek
        movem.l (sp)+,d2/d3/d4/a6
        rts

; file_close - closes a file
;
; in:      d0  int32  handle from file_open
; writes:  the table of open files
        routine file_close,d0
        move.l  a6,-(sp)
        lea     files,a0
        lea     -4(a0,d0.l*4),a0
        move.l  (a0),d1
        clr.l   (a0)
        movea.l dos_base,a6
        lvo     Close
        movea.l (sp)+,a6
        rts

; file_delete - deletes an incomplete file
;
; in:      d0  const char*  name, zero-terminated; closed
; error:   ignored: the failure that led here was printed already
        routine file_delete,d0
        move.l  a6,-(sp)
        move.l  d0,d1
        movea.l dos_base,a6
        lvo     DeleteFile
        movea.l (sp)+,a6
        rts

; print - writes text to the program's output
;
; in:      d0  const char*  text, zero-terminated
; error:   a failed write is ignored: there is nowhere to report it
        routine print,d0
        movem.l d2/d3/a6,-(sp)
        move.l  d0,d2
        movea.l d0,a0
        moveq   #-1,d3
.length addq.l  #1,d3
        tst.b   (a0)+
        bne.s   .length
        movea.l dos_base,a6
        lvo     Output
        move.l  d0,d1
        lvo     Write
        movem.l (sp)+,d2/d3/a6
        rts

; args_read - the program's arguments by a dos template
;
; in:      d0  const char*  template
;          d1  int32*  one longword an item, preset to the defaults
; out:     d0  int32   1 understood, 0 not
; writes:  the items; texts and numbers they point to live until the end
; formats: ReadArgs: /N items point to an int32
        routine args_read,d0,d1
        movem.l d2-d4/a6,-(sp)
        move.l  d1,d2
        move.l  d0,d4
        jsr     no_arguments
        move.l  d0,d3
        move.l  d4,d1
        movea.l dos_base,a6
        lvo     ReadArgs
        move.l  d0,read_args
        beq.s   .bad
        moveq   #1,d0
.bad    movem.l (sp)+,d2-d4/a6
        rts

; file_close_all - closes all open files and frees the arguments
;
; writes:  the table of open files
        section .text.dos_end,code
file_close_all:
        movem.l d2/a2/a6,-(sp)
        movea.l dos_base,a6
        lea     files,a2
        moveq   #FILES-1,d2
.file   move.l  (a2),d1
        beq.s   .closed
        clr.l   (a2)
        lvo     Close
.closed addq.l  #4,a2
        dbra    d2,.file
        move.l  read_args,d1
        beq.s   .no_args
        clr.l   read_args
        lvo     FreeArgs
.no_args
        movem.l (sp)+,d2/a2/a6
        rts

        section .bss.dos,bss
files           ds.l    FILES
read_args       ds.l    1
