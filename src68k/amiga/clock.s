; The clock: CIA-B's chained timers, which are also the watchdog of quiet mode, and the beam.
;
; The clock's tick is a colour clock, 4 cycles of the CPU. The timers count E-clocks, 20 cycles
; each (709,379 Hz and 14.18758 MHz).

        include "amiga.i"

        xdef    ciab_base

LINE_BIT                equ     15      ; of vposr and vhposr together, from the highest bit on:
LINE_BITS               equ     9       ; the raster line
BEAM_PLACE              equ     $40     ; colour clocks
LINE                    equ     227     ; colour clocks in a raster line
E_CLOCK                 equ     5       ; in an E-clock
ROUGH                   equ     4*E_CLOCK       ; the timers' error: both edges are waited for

; clock_open - takes CIA-B's two timers
;
; out:     d0  int32  1 if they are ours, 0 if another program has them
        routine clock_open
        movem.l d2/a6,-(sp)
        movea.l sys_base,a6
        lea     ciab_name(pc),a1
        lvo     OpenResource
        move.l  d0,ciab_base
        beq.s   .done
        movea.l d0,a6
        lea     timer_server,a1
        moveq   #ICRB_TA,d0
        lvo     AddICRVector
        tst.l   d0
        bne.s   .taken
        lea     timer_server,a1
        moveq   #ICRB_TB,d0
        lvo     AddICRVector
        tst.l   d0
        bne.s   .taken_b
        move.l  #ICRF_TB|1,d0           ; we poll: no interrupt from either
        lvo     AbleICR
        moveq   #1,d0
        bra.s   .done
.taken_b
        lea     timer_server,a1
        moveq   #ICRB_TA,d0
        lvo     RemICRVector
.taken  moveq   #0,d0
        clr.l   ciab_base
.done   movem.l (sp)+,d2/a6
        rts
ciab_name       dc.b    'ciab.resource',0
                even

; clock_close - gives the timers back
;
; error:   does nothing if they are not ours
        routine clock_close
        move.l  a6,-(sp)
        move.l  ciab_base,d0
        beq.s   .done
        clr.l   ciab_base
        movea.l d0,a6
        lea     timer_server,a1
        moveq   #ICRB_TA,d0
        lvo     RemICRVector
        lea     timer_server,a1
        moveq   #ICRB_TB,d0
        lvo     RemICRVector
.done   movea.l (sp)+,a6
        rts

; clock_wait - empties the instruction cache and waits for a fixed place of a raster line and a
;              fixed phase of the E-clock, from the field's first line on; on NTSC machines, where
;              that may not come, until line 128 at most
;
; reads:   CIA-B, the beam's position
; cost:    1 to 25 ms

; Chip RAM is refreshed at fixed places of each raster line, so code that starts at another
; place takes some ticks more or less. A line has 227 colour clocks, a prime, and an E-clock
; has 5, so every place of the line meets every phase. It waits twice: the second time the
; loop is in the cache. It begins at the field's first line, so that equal times contain
; equally many vertical blanks. NTSC's lines have 227 and 228 colour clocks by turns, two of
; them 91 E-clocks, so a place meets few phases.

        routine clock_wait
        move.l  a6,-(sp)
        movea.l sys_base,a6
        lvo     CacheClearU
        movea.l (sp)+,a6
        lea     custom,a0
.field  move.l  vposr(a0),d0
        bftst   d0{LINE_BIT:LINE_BITS}
        bne.s   .field
        lea     ciab,a1
        moveq   #BEAM_PLACE,d0
        moveq   #2-1,d1
.again  tst.b   ciatalo(a1)             ; ends with an E-clock
        cmp.b   vhposr+1(a0),d0
        beq.s   .there
        tst.b   vhposr(a0)              ; lines 128 to 255
        bpl.s   .again
.there  dbra    d1,.again
        rts

; clock_start - starts the clock and the watchdog; outside quiet mode the watchdog does not bite,
;               and the time of interrupts is included
;
; in:      d0  int32  limit before the watchdog bites, in 65,536 E-clocks (92 ms)
; reads:   the beam's position
; writes:  CIA-B timers A and B
; error:   limits from 1 to 65,535
        routine clock_start,d0
        lea     ciab,a0
        move.b  #CRAF_STOP,ciacra(a0)
        move.b  #CRBF_STOP,ciacrb(a0)
        move.l  d0,limit
        move.b  d0,ciatblo(a0)
        lsr.w   #8,d0
        move.b  d0,ciatbhi(a0)
        move.b  #$ff,ciatalo(a0)
        move.b  #$ff,ciatahi(a0)
        move.b  #CRBF_START_LOAD,ciacrb(a0)
        move.b  #CRAF_START_LOAD,ciacra(a0)
        move.b  custom+vhposr+1,place
        rts

; clock_stop - stops the clock
;
; out:     d0  uint32  colour clocks since clock_start, 4 CPU cycles each
; reads:   CIA-B timers A and B, the beam's position
; error:   one colour clock; ROUGH of them if raster lines do not have LINE of them each (NTSC);
;          the caller must subtract the constant cost of clock_start and clock_stop

; The timers count E-clocks, and their phase between two instructions is not known: a time is up
; to two of them off. The beam's place in its line gives the exact time.

        routine clock_stop
        moveq   #0,d0
        move.b  custom+vhposr+1,d0
        moveq   #0,d1
        move.b  place,d1
        sub.l   d1,d0
        movea.l d0,a1                   ; modulo LINE it is the time
        lea     ciab,a0
        move.b  #CRAF_STOP,ciacra(a0)
        move.b  #CRBF_STOP,ciacrb(a0)
        moveq   #0,d1
        move.b  ciatbhi(a0),d1
        lsl.w   #8,d1
        move.b  ciatblo(a0),d1
        move.l  limit,d0
        sub.l   d1,d0
        swap    d0                      ; underflows of timer A: 65,536 E-clocks
        moveq   #0,d1
        move.b  ciatahi(a0),d1
        lsl.w   #8,d1
        move.b  ciatalo(a0),d1
        not.w   d1                      ; it counts down from $ffff
        move.w  d1,d0
        move.l  d0,d1
        lsl.l   #2,d0
        add.l   d1,d0                   ; E_CLOCK each
        movea.l d0,a0
        moveq   #ROUGH,d1
        add.l   d1,d0
        sub.l   a1,d0
        divul.l #LINE,d1:d0             ; d1 = ROUGH + the lead of the timers
        move.l  a0,d0
        cmp.w   #2*ROUGH,d1
        bhi.s   .done
        sub.l   d1,d0
        moveq   #ROUGH,d1
        add.l   d1,d0
.done   rts

        section .data.clock,data
timer_server                            ; never called: we poll
        dc.l    0,0
        dc.b    2,0                     ; NT_INTERRUPT
        dc.l    timer_name,0,timer_code
timer_name      dc.b    'tmap020',0
                even
        section .text.timer_server,code
timer_code      rts

        section .bss.clock,bss
ciab_base       ds.l    1
limit           ds.l    1
place           ds.b    1               ; of the beam in its line, when the clock began
