; Runs other programs: each is loaded once and entered any number of times.

        include "amiga.i"

        xref    dos_base,start

; program_load - loads a program, until program_unload
;
; in:      d0  const char*  name, zero-terminated
; out:     d0  uint32   address of its first hunk's link, or 0: not loaded. A link is a quarter of
;                       the next one's address, or 0; the longword before it has the hunk's
;                       bytes, those of itself and the link included
; formats: AmigaDOS segment list
; error:   also 0 if memory is short
        routine program_load,d0
        move.l  a6,-(sp)
        move.l  d0,d1
        movea.l dos_base,a6
        lvo     LoadSeg
        lsl.l   #2,d0
        movea.l (sp)+,a6
        rts

; program_unload - gives a program's memory back
;
; in:      d0  uint32   from program_load
; reads:   the links
        routine program_unload,d0
        move.l  a6,-(sp)
        move.l  d0,d1
        lsr.l   #2,d1
        movea.l dos_base,a6
        lvo     UnLoadSeg
        movea.l (sp)+,a6
        rts

; program_base - where this program's code is, to which crash reports are relative
;
; out:     d0  uint32   its address
        routine program_base
        move.l  #start,d0
        rts

; program_enter - enters a loaded program as the shell does
;
; in:      d0  uint32   from program_load
;          d1  const char*  arguments, the last character a line feed
;          a0  int32    their bytes
; out:     d0  int32   its return code, or -1: not run
; writes:  whatever the program does
; error:   -1 if memory is short
        routine program_enter,d0,d1,a0
        movem.l d2-d4/a6,-(sp)
        move.l  d1,d3
        move.l  a0,d4
        move.l  d0,d1
        lsr.l   #2,d1
        move.l  #STACK,d2
        movea.l dos_base,a6
        lvo     RunCommand
        movem.l (sp)+,d2-d4/a6
        rts

; program_run - enters a loaded program as the shell does, its output in a file
;
; in:      d0  uint32   from program_load
;          d1  const char*  arguments, the last character a line feed
;          a0  int32    their bytes
;          a1  const char*  name of the file for its output
; out:     d0  int32   its return code, or -1: not run
; writes:  whatever the program does
; error:   -1 if the file cannot be made, or memory is short
        routine program_run,d0,d1,a0,a1
        movem.l d2-d7/a6,-(sp)
        move.l  d0,d5
        move.l  d1,d3
        move.l  a0,d4
        movea.l dos_base,a6
        move.l  a1,d1
        move.l  #MODE_NEWFILE,d2
        lvo     Open
        move.l  d0,d6
        beq.s   .not_run
        move.l  d6,d1
        lvo     SelectOutput
        move.l  d0,d7
        move.l  d5,d0
        move.l  d3,d1
        movea.l d4,a0
        jsr     program_enter
        move.l  d0,d5
        move.l  d7,d1
        lvo     SelectOutput
        move.l  d6,d1
        lvo     Close
        move.l  d5,d0
        bra.s   .done
.not_run
        moveq   #-1,d0
.done   movem.l (sp)+,d2-d7/a6
        rts

MODE_NEWFILE            equ     1006
STACK                   equ     4096    ; as the shell's commands have
