; Memory through exec. What a program allocates is noted here and freed when it ends.

        include "amiga.i"
        include "routine.i"

        xref    sys_base
        xref    program_end
        xref    _print
        xdef    mem_free_all

BLOCK_SIZE              equ     4       ; head of an allocated block: next, size
BLOCK_HEAD              equ     8
RETURN_FAIL             equ     20

;==============================================================================
; mem_alloc - allocates cleared memory, freed at the program's end
;
; in:      d0  void**  where the address goes
;          d1  int32   bytes
;          a0  int32   kind: 0 any (fast first), 2 chip, 4 fast
; out:     d0  int32   1 allocated, 0 not
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  *d0
; formats: -
; error:   *d0 is left alone where memory is short
; cost:    -
;==============================================================================
        routine mem_alloc,d0,d1,a0
        movem.l d2/d3/a6,-(sp)
        move.l  d0,d2
        move.l  d1,d3
        addq.l  #BLOCK_HEAD,d3
        move.l  d3,d0
        move.l  a0,d1
        or.l    #MEMF_CLEAR,d1
        movea.l sys_base,a6
        lvo     AllocMem
        tst.l   d0
        beq.s   .short
        movea.l d0,a0
        move.l  blocks,(a0)
        move.l  d3,BLOCK_SIZE(a0)
        move.l  a0,blocks
        addq.l  #BLOCK_HEAD,d0
        movea.l d2,a0
        move.l  d0,(a0)
        moveq   #1,d0
.short  movem.l (sp)+,d2/d3/a6
        rts

;==============================================================================
; mem_need - allocates cleared memory, or ends the program with a line
;
; in:      d0  void**  where the address goes
;          d1  int32   bytes
;          a0  int32   kind: 0 any (fast first), 2 chip, 4 fast
; out:     d0  int32   1: it returns only then
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  *d0
; formats: -
; error:   memory is short: prints so, return code 20
; cost:    -
;==============================================================================
; Programs of one scene call it wherever others call mem_alloc.

        routine mem_need,d0,d1,a0
        jsr     mem_alloc
        tst.l   d0
        beq.s   .short
        rts
.short  pea     .text(pc)
        jsr     _print
        moveq   #RETURN_FAIL,d0
        jmp     program_end
.text   dc.b    'not enough memory',10,0
        even

;==============================================================================
; mem_free_all - frees every block of mem_alloc
;
; in:      -
; out:     -
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  the list of blocks
; formats: -
; error:   -
; cost:    -
;==============================================================================
        section .text.mem_end,code
mem_free_all:
        movem.l a2/a6,-(sp)
        movea.l sys_base,a6
        move.l  blocks,d0
        bra.s   .test
.block  movea.l d0,a1
        move.l  BLOCK_SIZE(a1),d0
        movea.l (a1),a2
        lvo     FreeMem
        move.l  a2,d0
.test   tst.l   d0
        bne.s   .block
        clr.l   blocks
        movem.l (sp)+,a2/a6
        rts

        section .bss.memory,bss
blocks          ds.l    1
