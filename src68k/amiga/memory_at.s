; Memory at a certain address.

        include "amiga.i"

        xref    mem_blocks

; mem_take_at - allocates memory at an address, freed at the program's end
;
; in:      d0  void*  the address, a multiple of 8; BLOCK_HEAD bytes before it are taken too
;          d1  int32  bytes
; out:     d0  int32  1 allocated, 0 not
; writes:  the list of blocks
; error:   0 if some of that memory is not free
        routine mem_take_at,d0,d1
        movem.l d2/a6,-(sp)
        move.l  d1,d2
        addq.l  #BLOCK_HEAD,d2
        movea.l d0,a1
        subq.l  #BLOCK_HEAD,a1
        move.l  d2,d0
        movea.l sys_base,a6
        lvo     AllocAbs
        tst.l   d0
        beq.s   .none
        movea.l d0,a0
        keep_block d2
        moveq   #1,d0
.none   movem.l (sp)+,d2/a6
        rts

; mem_lists - exec's list of memory
;
; out:     d0  const void*  its first header: next, ..., as in exec's struct MemHeader
; formats: the last header's next has no next
        routine mem_lists
        movea.l sys_base,a0
        move.l  MemList(a0),d0
        rts
