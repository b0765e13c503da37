; Cycle by cycle on demand: UAE takes options from the programs that it runs.
;
; An emulated machine that counts no cycles is several times as fast. Where only some of a program's time is asked
; for, only that needs an exact machine.

        include "amiga.i"
        include "uae.i"

LINE_BIT                equ     15      ; of vposr and vhposr together: the raster line
LINE_BITS               equ     9

; exact_set - makes UAE cycle-exact, or not, from the next field on
;
; in:      d0  int32  1: exact; 0: not
; reads:   $F0FF60, the beam's position
; writes:  UAE's options
; error:   the machine must be UAE's: on another one nothing may be at that address
; cost:    returns after a field's first line: who then waits for such a line, as clock_wait does, waits for the change
        routine exact_set,d0
        lea     exact,a0
        tst.l   d0
        bne.s   .ask
        lea     rough,a0
.ask    clr.l   -(sp)
        movea.l sp,a1                   ; its answer is empty
        pea     4
        move.l  a1,-(sp)
        clr.l   -(sp)                   ; the text ends with a zero
        move.l  a0,-(sp)
        pea     -1                      ; set
        pea     UAE_OPTIONS
        jsr     UAE_TRAP
        lea     7*4(sp),sp
        lea     custom,a0
.first  move.l  vposr(a0),d0
        bftst   d0{LINE_BIT:LINE_BITS}
        beq.s   .first
        rts

        section .rodata.exact,data
; A processor that is not exact is several times as fast beside the chips. UAE works out the cycle's length anew as that
; changes.
exact   dc.b    'cpu_cycle_exact true cpu_compatible true blitter_cycle_exact true '
        dc.b    'waiting_blits true immediate_blits false cpu_throttle 1',0
rough   dc.b    'cpu_cycle_exact false cpu_compatible false blitter_cycle_exact false '
        dc.b    'waiting_blits no immediate_blits true cpu_throttle 5000',0
        even
