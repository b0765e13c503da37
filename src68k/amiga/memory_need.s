        include "routine.i"

        xref    mem_cleared,_print,program_end,quiet_leave
        xdef    mem_needed

; mem_need - allocates cleared memory, or ends the program with a message
;
; like:    mem_alloc
; out:     d0  int32   1; it returns only then
; error:   if memory is short it prints so and ends with return code 20

; Programs of one scene call it instead of mem_alloc.

        routine mem_need,d0,d1,a0
        jsr     mem_cleared

; mem_needed - ends the program with a message if memory is short
;
; in:      d0  int32  1 if there was enough, 0 if not
; out:     d0  int32  1; it returns only then
; error:   if memory is short it prints so and ends with return code 20
mem_needed
        tst.l   d0
        beq.s   .short
        rts
.short  jsr     quiet_leave             ; some programs allocate while they draw
        pea     .text(pc)
        jsr     _print
        moveq   #RETURN_FAIL,d0
        jmp     program_end
.text   dc.b    'not enough memory',10,0
        even
