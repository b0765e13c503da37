; Memory through exec. What a program allocates is noted here and freed when it ends.

        include "amiga.i"
        include "layout.i"
        include "routine.i"

        xref    program_end
        xref    _print
        xref    quiet_leave
        xdef    mem_free_all

BLOCK_SIZE              equ     4       ; head of an allocated block: next, size
BLOCK_HEAD              equ     8
ALIGN                   equ     8       ; of what is taken, as exec does

; Returns with what is set aside, or goes on. That is of any kind.
take    macro
        move.l  a0,-(sp)
        bne.s   .exec\@
        addq.l  #ALIGN-1,d1
        and.w   #-ALIGN,d1
        sub.l   d1,reserve_bytes
        blo.s   .back\@
        movea.l d0,a0
        move.l  reserve,(a0)
        add.l   d1,reserve
        moveq   #1,d0
        addq.l  #4,sp
        rts
.back\@ add.l   d1,reserve_bytes
.exec\@ movea.l (sp)+,a0
        endm

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
        move.l  d1,asked_bytes
        move.l  a0,asked_kind
        jmp     cleared

;==============================================================================
; mem_asked - what mem_alloc was last asked for
;
; in:      a0  int32*  where the kind goes
; out:     d0  int32   bytes
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  *a0
; formats: -
; error:   -
; cost:    -
;==============================================================================
        routine mem_asked,a0
        move.l  asked_kind,(a0)
        move.l  asked_bytes,d0
        rts

;==============================================================================
; mem_largest - the largest piece of memory that is free
;
; in:      d0  int32   kind: 0 any, 2 chip, 4 fast
; out:     d0  int32   bytes
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  -
; formats: -
; error:   -
; cost:    -
;==============================================================================
        routine mem_largest,d0
        move.l  a6,-(sp)
        move.l  d0,d1
        or.l    #MEMF_LARGEST,d1
        movea.l sys_base,a6
        lvo     AvailMem
        movea.l (sp)+,a6
        rts

; As mem_alloc.
        section .text.mem_cleared,code
cleared:
        movem.l d2/d3/a6,-(sp)
        move.l  d0,d2
        move.l  d1,d3
        move.l  a0,d1
        or.l    #MEMF_CLEAR,d1
; d2 = void**, d3 = bytes, d1 = what AllocMem is asked for.
allocate:
        addq.l  #BLOCK_HEAD,d3
        move.l  d3,d0
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

; As mem_take, from exec.
        section .text.mem_uncleared,code
uncleared:
        movem.l d2/d3/a6,-(sp)
        move.l  d0,d2
        move.l  d1,d3
        move.l  a0,d1
        jmp     allocate

;==============================================================================
; mem_reserve - sets memory aside for mem_take: half of the largest block
;
; in:      -
; out:     -
; trashes: d0-d1/a0-a1
; reads:   -
; writes:  -
; formats: -
; error:   none is set aside where there is none
; cost:    -
;==============================================================================
        routine mem_reserve
        moveq   #0,d0
        jsr     mem_largest
        lsr.l   #1,d0
        and.w   #-ALIGN,d0
        move.l  d0,d1
        suba.l  a0,a0
        move.l  d1,-(sp)
        move.l  #reserve,d0
        jsr     mem_take
        move.l  (sp)+,d1
        tst.l   d0
        beq.s   .none
        move.l  d1,reserve_bytes
.none   rts

;==============================================================================
; mem_take - allocates memory, freed at the program's end, in a time that does not depend on
;            what else is allocated, as long as what mem_reserve set aside lasts
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
        routine mem_take,d0,d1,a0
        take
        jmp     uncleared

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
        jsr     cleared
needed: tst.l   d0
        beq.s   .short
        rts
.short  jsr     quiet_leave             ; some ask while they draw
        pea     .text(pc)
        jsr     _print
        moveq   #RETURN_FAIL,d0
        jmp     program_end
.text   dc.b    'not enough memory',10,0
        even

;==============================================================================
; mem_need_take - mem_take, but ends the program with a line where memory is short
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
; Programs of one scene call it wherever others call mem_take.

        routine mem_need_take,d0,d1,a0
        take
        jsr     uncleared
        jmp     needed

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
asked_bytes     ds.l    1
asked_kind      ds.l    1
blocks          ds.l    1
reserve         ds.l    1
reserve_bytes   ds.l    1
