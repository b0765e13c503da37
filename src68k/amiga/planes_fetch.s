; The display's load on chip RAM, for measurements: fetches eight planes as c/screen's display
; does, without a copper list, from wherever the pointers are.

        include "amiga.i"

; planes_fetch - fetches eight planes, of 256 lines a field, or stops it; in quiet mode only
;
; in:      d0  uint32  enum plan_display
; writes:  bitplane registers: the system's copper list sets all of them again except FMODE, which
;          is 0 when it is stopped; DMACON, which quiet_leave restores then
        routine planes_fetch,d0
        lea     custom,a0
        move.w  #DMA_OFF,dmacon(a0)
        clr.w   fmode(a0)
        move.l  .modes(pc,d0.l*4),d1
        move.w  d1,bplcon0(a0)
        swap    d1
        move.w  d1,ddfstop(a0)
        beq.s   .done
        lea     .registers(pc),a1
.next   movem.w (a1)+,d0/d1
        move.w  d1,(a0,d0.w)
        tst.w   (a1)
        bne.s   .next
.done   rts
.modes  dc.w    0,$0200,$b8,$0211,$c8,$8211,$d0,$0251   ; ddfstop, bplcon0
.registers
        dc.w    fmode,3,bplcon1,0,bpl1mod,0,bpl2mod,0
        dc.w    diwstrt,$2081,diwstop,$20c1,diwhigh,$2100       ; lines 32 to 287
        dc.w    ddfstrt,$38,dmacon,DMA_ON,0

DMA_OFF                 equ     $0300   ; all, bitplanes
DMA_ON                  equ     $8300
