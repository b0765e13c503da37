; uaequit - the command that ends an FS-UAE session
;
; out:     d0  int32  0, if there is no UAE
; reads:   $F0FF60
; error:   returns if there is no UAE ($F0FF60 reads zero)

; A separate command, so that the programs stay ordinary Amiga programs.

        include "uae.i"

        xdef    start
        section .text.start,code
start:
        tst.l   UAE_TRAP
        beq.s   .absent
        pea     UAE_EXIT
        jsr     UAE_TRAP
        addq.l  #4,sp
.absent moveq   #0,d0
        rts
