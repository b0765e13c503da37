; Memory set aside, so that an allocation always takes the same time.

        include "routine.i"

        xref    mem_largest,mem_needed,mem_uncleared,mem_aside,mem_aside_bytes

ALIGN                   equ     8       ; of allocations, as exec's
RESERVE_MOST            equ     1024*1024

; Returns with memory from that set aside if kind is 0 (any) and enough is left; else goes on.
take    macro
        move.l  a0,-(sp)
        bne.s   .exec\@
        addq.l  #ALIGN-1,d1
        and.w   #-ALIGN,d1
        sub.l   d1,mem_aside_bytes
        blo.s   .back\@
        movea.l d0,a0
        move.l  mem_aside,(a0)
        add.l   d1,mem_aside
        moveq   #1,d0
        addq.l  #4,sp
        rts
.back\@ add.l   d1,mem_aside_bytes
.exec\@ movea.l (sp)+,a0
        endm

; mem_reserve - sets memory aside for mem_take: half of the largest block, 1 MB at most
;
; error:   if memory is short, sets nothing aside

; No more, because AROS writes over every byte that is freed.
        routine mem_reserve
        moveq   #0,d0
        jsr     mem_largest
        lsr.l   #1,d0
        moveq   #RESERVE_MOST>>16,d1
        swap    d1
        cmp.l   d1,d0
        bhs.s   .most
        move.l  d0,d1
.most   suba.l  a0,a0
        move.l  d1,-(sp)
        move.l  #mem_aside,d0
        jsr     mem_take
        movea.l (sp)+,a0
        tst.l   d0
        beq.s   .none
        move.l  a0,mem_aside_bytes
.none   rts

; mem_take - allocates memory, freed at the program's end, in a time that does not depend on other
;            allocations as long as the memory set aside by mem_reserve lasts
;
; like:    mem_alloc
        routine mem_take,d0,d1,a0
        take
        jmp     mem_uncleared

; mem_need_take - mem_take, but ends the program with a message if memory is short
;
; like:    mem_need

; Programs of one scene call it instead of mem_take.

        routine mem_need_take,d0,d1,a0
        take
        jsr     mem_uncleared
        jmp     mem_needed
