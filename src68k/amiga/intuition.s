; A screen of Intuition's: opens it among those of other programs, shows its two bitmaps in turn, takes its keys.
; Everything goes through the system's own calls; what it cannot tell is counted by a server of the vertical blank.

        include "intuition.i"

        xref    at_end,intuition_settle,intuition_show

NT_INTERRUPT            equ     2

; intuition_open - opens the screen with the first of its two bitmaps, and a window for its keys
;
; in:      a0  struct intuition*  the pointer is set, the rest is 0
; out:     d0  int32              1 open, 0 not
; writes:  what is set while it is open
; error:   0 if Kickstart is older than 3.0, if the display has no 8 planes in low resolution, or memory is short
; cost:    several fields
        routine intuition_open,a0
        movem.l d2-d3/a2-a3/a6,-(sp)
        movea.l a0,a2
        lea     ending,a0
        jsr     at_end
        lea     opened,a0
        move.l  (a0),intuition_next(a2)
        move.l  a2,(a0)
        movea.l sys_base,a6
        lea     intuition_name(pc),a1
        moveq   #VERSION_39,d0
        lvo     OpenLibrary
        move.l  d0,intuition_intuition_base(a2)
        beq.s   .failed
        lea     graphics_name(pc),a1
        moveq   #VERSION_39,d0
        lvo     OpenLibrary
        move.l  d0,intuition_graphics_base(a2)
        beq.s   .failed
        movea.l d0,a6
        moveq   #SETCHIPREV_BEST,d0     ; as SetPatch does: a disk that boots without it has no 8 planes
        lvo     SetChipRev
        btst    #GFXB_AA_LISA,d0        ; AROS opens such screens without her, too, and shows fewer planes
        beq.s   .failed
        movea.l sys_base,a6
        lvo     CreateMsgPort
        move.l  d0,intuition_port(a2)
        beq.s   .failed
        bsr.s   open_screen
        tst.l   d0
        beq.s   .failed
        bsr     open_buffers
        tst.l   d0
        beq.s   .failed
        bsr     count_fields
        moveq   #1,d0
.done   movem.l (sp)+,d2-d3/a2-a3/a6
        rts
.failed movea.l a2,a0
        jsr     intuition_close
        moveq   #0,d0
        bra.s   .done

intuition_name  dc.b    'intuition.library',0
graphics_name   dc.b    'graphics.library',0
                even

; Opens the screen and the window of a2; d0 = 0 if it cannot.
open_screen
        movea.l intuition_intuition_base(a2),a6
        move.l  sp,d2
        clr.l   -(sp)
        clr.l   -(sp)
        tag     SA_DisplayID,#LORES_KEY
        tag     SA_Type,#CUSTOMSCREEN
        tag     SA_Quiet,#1
        tag     SA_ShowTitle,#0
        tag     SA_Interleaved,#1       ; planes at equal distances
        tag     SA_Depth,#INTUITION_PLANES
        tag     SA_Height,#SCREEN_HEIGHT
        tag     SA_Width,#SCREEN_WIDTH
        suba.l  a0,a0
        movea.l sp,a1
        lvo     OpenScreenTagList
        movea.l d2,sp
        move.l  d0,intuition_screen(a2)
        beq.s   .done
        clr.l   -(sp)
        clr.l   -(sp)
        tag     WA_IDCMP,#IDCMP_RAWKEY
        tag     WA_Flags,#WINDOW_FLAGS
        tag     WA_CustomScreen,d0
        suba.l  a0,a0
        movea.l sp,a1
        lvo     OpenWindowTagList
        movea.l d2,sp
        move.l  d0,intuition_window(a2)
        beq.s   .done
        movea.l d0,a0
        movea.l intuition_pointer(a2),a1
        moveq   #0,d0                   ; rows
        moveq   #16,d1                  ; dots
        moveq   #0,d2
        moveq   #0,d3
        lvo     SetPointer
        moveq   #1,d0
.done   rts

; Gets the screen's bitmap and another one of a2, in buffers whose messages go to its port; or the screen's alone, for both,
; where AllocDBufInfo is wrong. d0 = 0 if it cannot.
open_buffers
        movea.l intuition_screen(a2),a0
        movea.l sc_BitMap(a0),a0
        move.l  a0,intuition_bitmap(a2)
        move.l  a0,intuition_bitmap+4(a2)
        bsr.s   probe
        bne.s   .check
        moveq   #SB_SCREEN_BITMAP,d0
        lea     intuition_buffer(a2),a3
        bsr.s   .buffer
        beq.s   .none
        moveq   #0,d0
        bsr.s   .buffer
        beq.s   .none
        movea.l d0,a0
        move.l  sb_BitMap(a0),intuition_bitmap+4(a2)
.check  movea.l intuition_graphics_base(a2),a6
        movea.l intuition_bitmap(a2),a0
        moveq   #BMA_FLAGS,d1
        lvo     GetBitMapAttr
        and.l   #BMF_STANDARD,d0        ; not a graphics card's
.none   rts
; Gets one by the flags d0, at a3; d0 = 0 and Z if it cannot.
.buffer movea.l intuition_intuition_base(a2),a6
        movea.l intuition_screen(a2),a0
        suba.l  a1,a1
        lvo     AllocScreenBuffer
        move.l  d0,(a3)+
        beq.s   .none
        movea.l d0,a0
        movea.l sb_DBufInfo(a0),a0
        move.l  intuition_port(a2),d1
        move.l  d1,dbi_SafeMessage+mn_ReplyPort(a0)
        move.l  d1,dbi_DispMessage+mn_ReplyPort(a0)
        tst.l   d0
        rts

; Whether AllocDBufInfo of a2's system is wrong: not Z. AROS of 2015 exchanges its arguments: it allocates AROS_WRONG bytes,
; which are not cleared, and frees them as fewer, when it closes the screen at the latest.
probe   movem.l d3/a3,-(sp)
        movea.l sys_base,a6
        lvo     Forbid
        moveq   #0,d1
        lvo     AvailMem
        move.l  d0,d3
        movea.l intuition_graphics_base(a2),a6
        movea.l intuition_screen(a2),a0
        lea     sc_ViewPort(a0),a0
        lvo     AllocDBufInfo
        movea.l d0,a3
        movea.l sys_base,a6
        moveq   #0,d1
        lvo     AvailMem
        sub.l   d0,d3
        lvo     Permit
        movea.l a3,a1
        cmp.l   #AROS_WRONG,d3
        bhs.s   .wrong
        movea.l intuition_graphics_base(a2),a6
        lvo     FreeDBufInfo
        moveq   #0,d0
        bra.s   .done
.wrong  move.l  #AROS_WRONG,d0
        lvo     FreeMem
        moveq   #1,d0
.done   movem.l (sp)+,d3/a3
        rts

; Adds a2's server.
count_fields
        lea     intuition_server(a2),a1
        move.b  #NT_INTERRUPT,is_Type(a1)
        move.l  #server_name,is_Name(a1)
        move.l  a2,is_Data(a1)
        move.l  #serve,is_Code(a1)
        movea.l sys_base,a6
        moveq   #INTB_VERTB,d0
        jmp     _LVOAddIntServer(a6)

; intuition_close - closes it, and whatever of it is open
;
; in:      a0  struct intuition*  from intuition_open
; writes:  what is set while it is open
; error:   does nothing if it is not open
        routine intuition_close,a0
        movem.l a2-a3/a6,-(sp)
        movea.l a0,a2
        lea     opened-intuition_next,a0
.look   movea.l a0,a1                   ; the one before
        move.l  intuition_next(a1),d0
        beq     .done
        movea.l d0,a0
        cmpa.l  a0,a2
        bne.s   .look
        move.l  intuition_next(a2),intuition_next(a1)
        tst.l   intuition_buffer+4(a2)
        beq.s   .one
        movea.l a2,a0
        moveq   #0,d0
        jsr     intuition_show          ; the screen closes with its own bitmap
        jsr     intuition_settle
.one
        movea.l sys_base,a6
        lea     intuition_server(a2),a1
        tst.l   is_Code(a1)
        beq.s   .not_counted
        clr.l   is_Code(a1)
        moveq   #INTB_VERTB,d0
        lvo     RemIntServer
.not_counted
        movea.l intuition_intuition_base(a2),a6
        move.l  intuition_window(a2),d0
        beq.s   .no_window
        movea.l d0,a0
        lvo     CloseWindow
.no_window
        lea     intuition_buffer(a2),a3
        bsr.s   .free
        bsr.s   .free
        move.l  intuition_screen(a2),d0
        beq.s   .no_screen
        movea.l d0,a0
        lvo     CloseScreen
.no_screen
        movea.l sys_base,a6
        move.l  intuition_port(a2),d0
        beq.s   .no_port
        movea.l d0,a0
        lvo     DeleteMsgPort
.no_port
        move.l  intuition_graphics_base(a2),d0
        beq.s   .no_graphics
        movea.l d0,a1
        lvo     CloseLibrary
.no_graphics
        move.l  intuition_intuition_base(a2),d0
        beq.s   .done
        movea.l d0,a1
        lvo     CloseLibrary
.done   movem.l (sp)+,a2-a3/a6
        rts
.free   move.l  (a3)+,d0
        beq.s   .none
        movea.l d0,a1
        movea.l intuition_screen(a2),a0
        jmp     _LVOFreeScreenBuffer(a6)
.none   rts

; Closes all that are open, at the program's end.
close_all
        move.l  opened,d0
        beq.s   .none
        movea.l d0,a0
        bsr     intuition_close
        bra.s   close_all
.none   rts

; Counts a field of the screen a1.
        section .text.intuition_server,code
        cnop    0,4
serve:  addq.l  #1,intuition_fields(a1)
        moveq   #0,d0
        rts

        section .data.intuition,data
ending  dc.l    0,close_all             ; struct end
server_name
        dc.b    'tmap020 fields',0
        even

        section .bss.intuition,bss
opened  ds.l    1
