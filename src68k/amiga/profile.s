; Interrupts a program at regular intervals while its frames are timed, and notes the places that it has
; reached, so that the tools know where its time goes. Linked in for that run only.

        include "amiga.i"

        xref    _main,_file_save,clock_start,clock_stop,start
        xref    _n64_polygon_draw,_n64_polygon_draw_coloured,_n64_rectangle_draw,_glide_polygon_draw

PROFILE_NOTES           equ     147456
PROFILE_PERIOD          equ     101     ; E-clocks: 2,020 cycles; a prime, so that no loop keeps step
PLACE_BITS              equ     18      ; of a note: a place in the code's first 512 KB, in words
VECTOR_LEVEL_2          equ     $68

; profile_main - runs main and writes the file profile.notes
;
; out:     d0  int32  what main returns
; formats: a long for each note: in bits 0 to 17 the place of the next instruction, in words from `start` on; above them
;          0, or the number of the material whose polygon a texture unit drew, plus 1
; error:   code after the first 512 KB is not noted; an interrupt waits for the end of an instruction, and takes some
;          60 bytes of the instruction cache; when all PROFILE_NOTES are taken, every second one is dropped, and half
;          as many are made from then on
; cost:    some 220 cycles a note
        routine profile_main
        move.l  #profile_notes,profile_next
        move.l  #$10001,profile_left    ; and profile_each
        jsr     _main
        move.l  d0,-(sp)
        move.l  profile_next,d0
        sub.l   #profile_notes,d0
        move.l  d0,-(sp)
        pea     profile_notes
        pea     .name(pc)
        jsr     _file_save
        lea     12(sp),sp
        move.l  (sp)+,d0
        rts
.name   dc.b    'profile.notes',0
        even

; What is drawn by the routine \1, which has a material as its third argument, is noted as that material's.
note_as macro
        move.l  profile_material,-(sp)
        movea.l 16(sp),a0
        moveq   #1,d0
        add.w   material_number(a0),d0
        moveq   #PLACE_BITS,d1
        lsl.l   d1,d0
        move.l  d0,profile_material
        move.l  16(sp),-(sp)
        move.l  16(sp),-(sp)
        move.l  16(sp),-(sp)
        jsr     \1
        lea     12(sp),sp
        move.l  (sp)+,profile_material
        rts
        endm

; profile_polygon - replaces n64_polygon_draw
;
; out:     d0  int32  what that returns
; writes:  the current material; what that does
        routine profile_polygon
        note_as _n64_polygon_draw

; profile_coloured - replaces n64_polygon_draw_coloured
;
; like:    profile_polygon
        routine profile_coloured
        note_as _n64_polygon_draw_coloured

; profile_rectangle - replaces n64_rectangle_draw
;
; like:    profile_polygon
        routine profile_rectangle
        note_as _n64_rectangle_draw

; profile_glide - replaces glide_polygon_draw
;
; like:    profile_polygon
        routine profile_glide
        note_as _glide_polygon_draw

; profile_start - replaces clock_start; begins to note as well
;
; in:      d0  int32  limit before the watchdog bites, in 65,536 E-clocks
; reads:   the beam's position
; writes:  CIA-B timers A and B, CIA-A timer B, INTENA, the level 2 vector
; error:   only in quiet mode, which has switched all interrupts off; those of CIA-A stay off, so the machine is fit
;          for no more than writing files
        routine profile_start,d0
        movem.l d0/a5/a6,-(sp)
        movea.l sys_base,a6
        lea     .vector(pc),a5
        lvo     Supervisor
        lea     ciaa,a0
        move.b  #ICRF_ALL,ciaicr(a0)
        move.b  #PROFILE_PERIOD,ciatblo(a0)
        clr.b   ciatbhi(a0)
        tst.b   ciaicr(a0)
        move.b  #ICRF_SETCLR|ICRF_TB,ciaicr(a0)
        move.b  #CRBF_COUNT_E,ciacrb(a0)
        move.w  #INTF_PORTS,custom+intreq
        move.w  #INTF_SETCLR|INTF_PORTS,custom+intena
        movem.l (sp)+,d0/a5/a6
        jmp     clock_start
.vector movec   vbr,a0
        move.l  VECTOR_LEVEL_2(a0),old_level_2
        move.l  #profile_note,VECTOR_LEVEL_2(a0)
        rte

; profile_stop - replaces clock_stop; ends noting as well
;
; out:     d0  uint32  colour clocks since profile_start, with those of noting
; reads:   CIA-B timers A and B, the beam's position
; writes:  CIA-A timer B, INTENA, the level 2 vector
        routine profile_stop
        movem.l a5/a6,-(sp)
        move.w  #INTF_PORTS,custom+intena
        move.b  #CRBF_STOP,ciaa+ciacrb
        move.b  #ICRF_ALL,ciaa+ciaicr
        tst.b   ciaa+ciaicr
        move.w  #INTF_PORTS,custom+intreq
        movea.l sys_base,a6
        lea     .vector(pc),a5
        lvo     Supervisor
        movem.l (sp)+,a5/a6
        jmp     clock_stop
.vector movec   vbr,a0
        move.l  old_level_2,VECTOR_LEVEL_2(a0)
        rte

profile_note:                           ; the stacked PC: the next instruction
        movem.l d0/a0,-(sp)
        tst.b   ciaa+ciaicr             ; reading clears its flags
        move.w  #INTF_PORTS,custom+intreq
        subq.w  #1,profile_left
        bne.s   .done
        move.w  profile_each,profile_left
        move.l  8+2(sp),d0
        sub.l   #start,d0
        lsr.l   #1,d0
        cmp.l   #1<<PLACE_BITS,d0
        bcc.s   .done
        or.l    profile_material,d0
        movea.l profile_next,a0
        move.l  d0,(a0)+
        cmpa.l  #profile_full,a0
        bne.s   .kept
        lea     profile_notes,a0
        move.l  a1,-(sp)
        movea.l a0,a1
.halve  move.l  (a1),(a0)+
        addq.l  #8,a1
        cmpa.l  #profile_full,a1
        bcs.s   .halve
        movea.l (sp)+,a1
        move.w  profile_each,d0
        add.w   d0,profile_each
.kept   move.l  a0,profile_next
.done   movem.l (sp)+,d0/a0
        rte

        section .bss.profile,bss
old_level_2     ds.l    1
profile_next    ds.l    1
profile_material ds.l   1
profile_left    ds.w    1               ; interrupts until the next note
profile_each    ds.w    1               ; interrupts to a note
profile_notes   ds.l    PROFILE_NOTES
profile_full    ds.l    0
