; The palette and the keys of a screen of Intuition's.

        include "intuition.i"

; intuition_colours_set - sets colours of the screen
;
; in:      a0  struct intuition*  an open one
;          a1  const struct intuition_colours*  which, and their parts
; writes:  the screen's palette
        routine intuition_colours_set,a0,a1
        move.l  a6,-(sp)
        movea.l intuition_graphics_base(a0),a6
        movea.l intuition_screen(a0),a0
        lea     sc_ViewPort(a0),a0
        lvo     LoadRGB32
        movea.l (sp)+,a6
        rts

; intuition_key - the next key that was pressed in the screen's window
;
; in:      a0  struct intuition*  an open one
; out:     d0  uint32             its raw code, 0 to $7f, or $ffffffff: none
; writes:  the window's messages; Ctrl-C signals the task
; error:   none comes while another window is active
        routine intuition_key,a0
        movem.l d2-d3/a2/a6,-(sp)
        movea.l intuition_window(a0),a2
        movea.l sys_base,a6
.next   moveq   #-1,d2
        movea.l wd_UserPort(a2),a0
        lvo     GetMsg
        tst.l   d0
        beq.s   .done
        movea.l d0,a1
        moveq   #0,d2
        move.w  im_Code(a1),d2
        move.w  im_Qualifier(a1),d3
        lvo     ReplyMsg
        btst    #7,d2                   ; released
        bne.s   .next
        btst    #IEQUALIFIERB_REPEAT,d3
        bne.s   .next
        btst    #IEQUALIFIERB_CONTROL,d3
        beq.s   .done
        cmp.b   #C_KEY,d2
        bne.s   .done
        suba.l  a1,a1
        lvo     FindTask
        movea.l d0,a1
        move.l  #SIGBREAKF_CTRL_C,d0
        lvo     Signal
        bra.s   .next
.done   move.l  d2,d0
        movem.l (sp)+,d2-d3/a2/a6
        rts
