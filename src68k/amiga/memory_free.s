; Frees memory: from a mark on, or all of it.

        include "amiga.i"

        xref    mem_aside_bytes,mem_blocks
        xdef    mem_free_all

; mem_mark - marks the current allocations: mem_release frees all later ones
;
; out:     d0  uint32  the mark
; reads:   the list of blocks
        routine mem_mark
        move.l  mem_blocks,d0
        rts

; mem_release - frees all memory allocated since mem_mark, and gives up the memory set aside
;
; in:      d0  uint32  the mark; no older one may have been released
; writes:  the list of blocks
        routine mem_release,d0
        movem.l a2/a3/a6,-(sp)
        movea.l d0,a2
        movea.l sys_base,a6
        clr.l   mem_aside_bytes
.block  movea.l mem_blocks,a1
        cmpa.l  a1,a2
        beq.s   .done
        movea.l (a1),a3
        move.l  BLOCK_SIZE(a1),d0
        lvo     FreeMem
        move.l  a3,mem_blocks
        bra.s   .block
.done   movem.l (sp)+,a2/a3/a6
        rts

; mem_free_all - frees every block of mem_alloc
;
; writes:  the list of blocks
        section .text.mem_end,code
mem_free_all:
        movem.l a2/a6,-(sp)
        movea.l sys_base,a6
        move.l  mem_blocks,d0
        bra.s   .test
.block  movea.l d0,a1
        move.l  BLOCK_SIZE(a1),d0
        movea.l (a1),a2
        lvo     FreeMem
        move.l  a2,d0
.test   tst.l   d0
        bne.s   .block
        clr.l   mem_blocks
        movem.l (sp)+,a2/a6
        rts
