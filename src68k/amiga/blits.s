; Blits one after the other: each one's interrupt starts the next.

        include "amiga.i"

        xref    at_end,gfx_base,display_post

; blits_start - begins a list of blits, which go on while the program does
;
; in:      a0  blit_list*  the list and its blits, in memory that stays
; writes:  the blitter's registers, its interrupt
; error:   the display must be ours; blits_end must be called before the next list, and before the system draws
; cost:    waits for the system's blits
        routine blits_start,a0
        movem.l a2/a5/a6,-(sp)
        movea.l a0,a2
        move.l  a2,server+IS_DATA
        lea     ending,a0
        jsr     at_end
        movea.l gfx_base,a6
        lvo     OwnBlitter
        lvo     WaitBlit
        movea.l sys_base,a6
        moveq   #INTB_BLIT,d0
        lea     server,a1
        lvo     SetIntVector
        move.l  d0,before
        st      is_ours
        lea     custom,a0
        move.w  #INTF_BLIT,intreq(a0)   ; of blits before
        move.w  #INTF_SETCLR|INTF_BLIT,intena(a0)
        movea.l a2,a1
        bsr.s   start
        movem.l (sp)+,a2/a5/a6
        rts

; Starts the next blit of the list a1. Keeps a0 = custom; uses d0-d1/a5.
start   movea.l blit_list_next(a1),a5
        move.l  (a5)+,bltcon0(a0)       ; blit_control
        moveq   #-1,d0
        move.l  d0,bltafwm(a0)
        moveq   #0,d0
        move.w  d0,bltbmod(a0)
        move.l  d0,bltamod(a0)          ; and bltdmod
        move.l  (a5)+,bltapt(a0)
        move.l  (a5)+,bltbpt(a0)
        move.l  (a5)+,bltdpt(a0)
        move.w  (a5)+,bltcdat(a0)
        move.l  (a5)+,d0                ; blit_rows, blit_words
        addq.l  #blit_sizeof-blit_unused,a5
        move.l  a5,blit_list_next(a1)
        move.l  d0,bltsizv(a0)          ; and bltsizh, which starts it
        rts

; A blit has ended: exec's vector, with a0 = custom, a1 = the list.
serve   move.w  #INTF_BLIT,intreq(a0)
        subq.l  #1,blit_list_left(a1)
        bgt.s   start
        move.l  blit_list_list(a1),d0
        beq.s   .done
        move.l  blit_list_field(a1),d1
        jmp     display_post
.done   rts

; blits_end - waits until the list is done, and gives the blitter back
;
; writes:  the blitter's interrupt
; error:   does nothing if no list has begun
        routine blits_end
        move.l  a6,-(sp)
        tst.b   is_ours
        beq.s   .done
        movea.l server+IS_DATA,a0
.wait   tst.l   blit_list_left(a0)
        bgt.s   .wait
        move.w  #INTF_BLIT,custom+intena
        movea.l sys_base,a6
        moveq   #INTB_BLIT,d0
        movea.l before,a1
        lvo     SetIntVector
        movea.l gfx_base,a6
        lvo     DisownBlitter
        sf      is_ours
.done   movea.l (sp)+,a6
        rts

        section .data.blits,data
server  dc.l    0,0
        dc.b    2,0                     ; NT_INTERRUPT
        dc.l    server_name
IS_DATA equ     14
        dc.l    0,serve
ending  dc.l    0,blits_end             ; struct end
server_name
        dc.b    'tmap020 blits',0
        even

        section .bss.blits,bss
before  ds.l    1                       ; the vector's server
is_ours ds.b    1
        even
