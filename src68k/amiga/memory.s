; Memory through exec. A program's allocations are noted here and freed when it ends.

        include "amiga.i"

        xdef    mem_cleared,mem_uncleared,mem_blocks,mem_aside,mem_aside_bytes

; mem_alloc - allocates cleared memory, freed at the program's end
;
; in:      d0  void**  where the address goes
;          d1  int32   bytes
;          a0  int32   kind: 0 any (fast first), 2 chip, 4 fast
; out:     d0  int32   1 allocated, 0 not
; error:   *d0 is unchanged if memory is short
        routine mem_alloc,d0,d1,a0
        move.l  d1,asked_bytes
        move.l  a0,asked_kind
        jmp     mem_cleared

; mem_asked - bytes and kind of the last request to mem_alloc
;
; in:      a0  int32*  where the kind goes
; out:     d0  int32   bytes
        routine mem_asked,a0
        move.l  asked_kind,(a0)
        move.l  asked_bytes,d0
        rts

; mem_largest - the largest piece of memory that is free
;
; in:      d0  int32   kind: 0 any, 2 chip, 4 fast
; out:     d0  int32   bytes
        routine mem_largest,d0
        move.l  a6,-(sp)
        move.l  d0,d1
        or.l    #MEMF_LARGEST,d1
        movea.l sys_base,a6
        lvo     AvailMem
        movea.l (sp)+,a6
        rts

; mem_cleared - mem_alloc without a record for mem_asked
;
; like:    mem_alloc
        section .text.mem_cleared,code
mem_cleared:
        movem.l d2/d3/a6,-(sp)
        move.l  d0,d2
        move.l  d1,d3
        move.l  a0,d1
        or.l    #MEMF_CLEAR,d1
; d2 = void**, d3 = bytes, d1 = AllocMem's flags.
allocate:
        addq.l  #BLOCK_HEAD,d3
        move.l  d1,-(sp)
        and.l   #~MEMF_CLEAR,d1
        or.l    #MEMF_LARGEST,d1
        movea.l sys_base,a6
        lvo     AvailMem
        move.l  (sp)+,d1
        cmp.l   d3,d0
        blo.s   .none                   ; AROS's handlers for a lack of memory may not return
        move.l  d3,d0
        lvo     AllocMem
        tst.l   d0
        beq.s   .short
        movea.l d0,a0
        keep_block d3
        addq.l  #BLOCK_HEAD,d0
        movea.l d2,a0
        move.l  d0,(a0)
        moveq   #1,d0
.short  movem.l (sp)+,d2/d3/a6
        rts
.none   moveq   #0,d0
        bra.s   .short

; mem_uncleared - mem_take from exec only, without the memory set aside
;
; like:    mem_alloc
        section .text.mem_uncleared,code
mem_uncleared:
        movem.l d2/d3/a6,-(sp)
        move.l  d0,d2
        move.l  d1,d3
        move.l  a0,d1
        jmp     allocate

        section .bss.memory,bss
asked_bytes     ds.l    1
asked_kind      ds.l    1
mem_blocks      ds.l    1               ; the last block that was allocated
mem_aside       ds.l    1               ; start of the memory set aside
mem_aside_bytes ds.l    1               ; its bytes
