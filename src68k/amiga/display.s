; Takes the display from the system and gives it back: shows our own copper lists while tasks and
; interrupts go on. The lists alone define the picture.

        include "amiga.i"

        xref    at_end
        xdef    gfx_base

LAST_LINE               equ     20      ; the last line in which a list may be started: it must
                                        ; have set its colours before the picture begins
PRIORITY                equ     5       ; after the system's own servers

; The server's data.
FIELDS                  equ     0
NEXT                    equ     4       ; the list to show next
DUE                     equ     8       ; the field from which on to show it
SET                     equ     12      ; the list that the copper takes at the next field
SHOWN                   equ     16      ; the list that the copper runs
SINCE                   equ     20      ; the first field of that list

; display_has_aga - checks for AGA
;
; out:     d0  int32  1 if the machine has it, 0 if not
; reads:   Denise's number

; The first Denise has no number: a read gives the last value on the bus.

        routine display_has_aga
        moveq   #8-1,d1
.again  cmp.b   #LISA,custom+denise_id+1
        bne.s   .none
        dbra    d1,.again
        moveq   #1,d0
        rts
.none   moveq   #0,d0
        rts

; display_open - takes the display over and shows a list, until display_close or the end
;
; in:      d0  uint16*  copper list in chip RAM
; out:     d0  int32    1 taken, 0 not
; writes:  the copper's first list, DMACON, BEAMCON0 of NTSC machines
; error:   0 if it is taken already, or there is no graphics.library
; cost:    two fields or more
        routine display_open,d0
        movem.l d2/a6,-(sp)
        move.l  d0,d2
        moveq   #0,d0
        tst.l   gfx_base
        bne     .done
        movea.l sys_base,a6
        lea     .name(pc),a1
        lvo     OpenLibrary
        move.l  d0,gfx_base
        beq     .done
        movea.l d0,a6
        move.l  gb_ActiView(a6),old_view
        move.w  custom+dmaconr,old_dmacon
        lea     ending,a0
        jsr     at_end
        suba.l  a1,a1
        lvo     LoadView
        lvo     WaitTOF
        lvo     WaitTOF                 ; interlaced views have two lists
        btst    #PAL_BIT,gb_DisplayFlags+1(a6)
        bne.s   .pal
        move.w  #BEAMCON_PAL,custom+beamcon0
.pal    lea     state,a0
        move.l  d2,NEXT(a0)
        move.l  FIELDS(a0),DUE(a0)
        clr.l   SET(a0)
        clr.l   SHOWN(a0)
        movea.l sys_base,a6
        lea     server,a1
        moveq   #INTB_VERTB,d0
        lvo     AddIntServer
        bsr.s   wait_shown
        move.w  #DMA_ON,custom+dmacon
        moveq   #1,d0
.done   movem.l (sp)+,d2/a6
        rts
.name   dc.b    'graphics.library',0
        even

wait_shown
        movea.l gfx_base,a6
.wait   lvo     WaitTOF
        lea     state,a0
        move.l  NEXT(a0),d0
        cmp.l   SHOWN(a0),d0
        bne.s   .wait
        rts

DMA_ON                  equ     $8380   ; all, bitplanes, copper

; display_show - shows another list from the next field on; returns when it is shown
;
; in:      d0  uint16*  copper list in chip RAM
; writes:  the copper's first list
; error:   the display must be ours
; cost:    a field or two
        routine display_show,d0
        move.l  a6,-(sp)
        move.l  state+FIELDS,state+DUE
        move.l  d0,state+NEXT
        bsr.s   wait_shown
        movea.l (sp)+,a6
        rts

; display_post - shows another list from a field on; returns at once
;
; in:      d0  uint16*  copper list in chip RAM
;          d1  uint32   field, as display_fields counts; the next one if it is over
; writes:  the copper's first list, when it is time
; error:   the display must be ours, and the list posted before must be shown
        routine display_post,d0,d1
        move.l  d1,state+DUE            ; first: until then the old list is the next one
        move.l  d0,state+NEXT
        rts

; display_since - the first field of the list that the copper runs
;
; out:     d0  uint32  the field, as display_fields counts
        routine display_since
        move.l  state+SINCE,d0
        rts

; display_age - how long the copper has run its list
;
; out:     d0  uint32  raster lines since its first field began, 312 a field
; reads:   the beam's position
; error:   a line each field if they have 313
        routine display_age
        lea     state,a0
        lea     custom,a1
.again  move.l  FIELDS(a0),d0
        move.l  vposr(a1),d1
        cmp.l   FIELDS(a0),d0
        bne.s   .again
        lsr.l   #8,d1
        and.l   #$1ff,d1
        cmp.w   #FIELD_LINES/2,d1
        bhi.s   .counted
        btst    #INTB_VERTB,intreqr+1(a1)
        beq.s   .counted
        addq.l  #1,d0                   ; a field that has begun just now
.counted
        sub.l   SINCE(a0),d0
        mulu.w  #FIELD_LINES,d0
        add.l   d1,d0
        rts

FIELD_LINES             equ     312

; display_wait - waits for the field after a given one, unless it is over; other tasks run until then
;
; in:      d0  uint32  the field, as display_fields counts
; error:   the display must be ours
; cost:    a field at most

; Interrupts are off from the comparison on, until the system lets other tasks run: a field that begins between
; both would be missed, and another one waited for.
        routine display_wait,d0
        movem.l d2/a6,-(sp)
        move.l  d0,d2
        movea.l sys_base,a6
        lvo     Disable
        cmp.l   state+FIELDS,d2
        bne.s   .over
        movea.l gfx_base,a6
        lvo     WaitTOF
        movea.l sys_base,a6
.over   lvo     Enable
        movem.l (sp)+,d2/a6
        rts

; display_shown - the list that the copper runs
;
; out:     d0  uint32  the list's address
        routine display_shown
        move.l  state+SHOWN,d0
        rts

; display_fields - fields while the display was ours
;
; out:     d0  uint32  vertical blanks, 50 a second
        routine display_fields
        move.l  state+FIELDS,d0
        rts

; display_close - gives the display back
;
; writes:  the same as display_open
; error:   does nothing if it is not ours
; cost:    two fields or more
        routine display_close
        movem.l d2/a6,-(sp)
        move.l  gfx_base,d2
        beq     .done
        clr.l   gfx_base
        movea.l sys_base,a6
        lea     server,a1
        moveq   #INTB_VERTB,d0
        lvo     RemIntServer
        movea.l d2,a6
        lea     custom,a0
        move.l  gb_copinit(a6),cop1lc(a0)
        btst    #PAL_BIT,gb_DisplayFlags+1(a6)
        bne.s   .pal
        clr.w   beamcon0(a0)
.pal    lvo     WaitTOF
        lea     custom,a0
        move.w  #BPLCON0_NONE,bplcon0(a0)
        move.w  #BPLCON3_RESET,bplcon3(a0)
        move.w  #BPLCON4_RESET,bplcon4(a0)
        clr.w   fmode(a0)
        movea.l old_view,a1
        lvo     LoadView
        lvo     WaitTOF
        lvo     WaitTOF
        move.w  #DMA_DISPLAY,custom+dmacon
        move.w  old_dmacon,d0
        and.w   #DMA_DISPLAY,d0
        or.w    #INTF_SETCLR,d0
        move.w  d0,custom+dmacon
        movea.l a6,a1
        movea.l sys_base,a6
        lvo     CloseLibrary
.done   movem.l (sp)+,d2/a6
        rts

BPLCON0_NONE            equ     $0200
BPLCON3_RESET           equ     $0c00
BPLCON4_RESET           equ     $0011
DMA_DISPLAY             equ     $01a0   ; bitplanes, copper, sprites

; Runs in each field. A list that comes too late to be started at once is shown a field later.
; Sets COP1LC again, as the system may have changed it.
        section .text.display_server,code
        cnop    0,4
serve:  lea     custom,a0               ; exec expects it there on return
        addq.l  #1,FIELDS(a1)
        move.l  SET(a1),d0
        cmp.l   SHOWN(a1),d0
        beq.s   .shown
        bsr.s   .show                   ; it was too late a field ago
.shown  move.l  FIELDS(a1),d1
        sub.l   DUE(a1),d1
        bmi.s   .not_due
        move.l  NEXT(a1),d0
.not_due
        move.l  d0,cop1lc(a0)
        cmp.l   SET(a1),d0
        beq.s   .done
        move.l  d0,SET(a1)
        move.l  vposr(a0),d1
        lsr.l   #8,d1
        and.w   #$1ff,d1
        cmp.w   #LAST_LINE,d1
        bhi.s   .done
        move.w  d0,copjmp1(a0)
        bsr.s   .show
.done   moveq   #0,d0
        rts
.show   move.l  d0,SHOWN(a1)
        move.l  FIELDS(a1),SINCE(a1)
        rts

        section .data.display,data
server  dc.l    0,0
        dc.b    2,PRIORITY              ; NT_INTERRUPT
        dc.l    server_name,state,serve
ending  dc.l    0,display_close         ; struct end
server_name
        dc.b    'tmap020 display',0
        even

        section .bss.display,bss
gfx_base        ds.l    1
old_view        ds.l    1
state           ds.l    6
old_dmacon      ds.w    1
