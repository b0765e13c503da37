; Records every instruction that a program executes, so that the tools know the parts of the
; renderer that a scene needs. Linked in for that run only.

        include "amiga.i"

        xref    _main,_file_save,clock_start,start,quiet

TRACE_WORDS             equ     147456  ; of code: 288 KB
TRACE_LIMIT             equ     65535   ; in units of 92 ms: the timer's maximum
TRACED                  equ     0       ; bits
TRACED_QUIET            equ     1
TRACED_AGAIN            equ     2
VECTOR_TRACE            equ     $24
SR_TRACE                equ     $8000

; trace_main - runs main and writes the file trace.flags
;
; out:     d0  int32  what main returns
; writes:  the trace vector, restored at the end
; formats: a byte for each word of the code from `start` on: bit 0 an instruction begins
;          there and was executed, bit 1 in quiet mode, bit 2 more than once in quiet mode
; error:   code after the first 288 KB is not recorded
; cost:    some 20 times the program's own time
        routine trace_main
        movem.l d2/a5/a6,-(sp)
        movea.l sys_base,a6
        lea     .on(pc),a5
        lvo     Supervisor
        jsr     _main
        move.l  d0,d2
        movea.l sys_base,a6
        lea     .off(pc),a5
        lvo     Supervisor
        move.l  #TRACE_WORDS,-(sp)
        pea     trace_flags
        pea     .name(pc)
        jsr     _file_save
        lea     12(sp),sp
        move.l  d2,d0
        movem.l (sp)+,d2/a5/a6
        rts
.on     movec   vbr,a0
        move.l  VECTOR_TRACE(a0),old_trace
        move.l  #trace_step,VECTOR_TRACE(a0)
        or.w    #SR_TRACE,(sp)
        rte
.off    movec   vbr,a0
        move.l  old_trace,VECTOR_TRACE(a0)
        and.w   #SR_TRACE-1,(sp)        ; clears the highest bit
        rte
.name   dc.b    'trace.flags',0
        even

trace_step:                             ; the stacked PC: the next instruction
        movem.l d0/a0,-(sp)
        move.l  8+2(sp),d0
        sub.l   #start,d0
        lsr.l   #1,d0
        cmp.l   #TRACE_WORDS,d0
        bcc.s   .done
        lea     trace_flags,a0
        adda.l  d0,a0
        bset    #TRACED,(a0)
        tst.b   quiet
        beq.s   .done
        bset    #TRACED_QUIET,(a0)
        beq.s   .done
        bset    #TRACED_AGAIN,(a0)
.done   movem.l (sp)+,d0/a0
        rte

; trace_wait - replaces clock_wait while instructions are recorded; does nothing
;
; trashes: -

; clock_wait's loops wait for one place of the beam; traced, each round takes several lines and
; could miss that place forever.
        routine trace_wait
        rts

; trace_start - replaces clock_start while instructions are recorded; sets the longest limit
;
; in:      d0  int32  limit before the watchdog bites, ignored
; writes:  CIA-B timers A and B
        routine trace_start,d0
        move.l  #TRACE_LIMIT,d0
        bra     clock_start

        section .bss.trace,bss
old_trace       ds.l    1
trace_flags     ds.b    TRACE_WORDS
