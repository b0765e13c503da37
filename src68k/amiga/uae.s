; uae - the command that speaks to the emulator for the start-up script: "uae" ends it, "uae exact" makes it cycle-exact
;
; in:      a0  const uint8 *  the rest of its line
; out:     d0  int32  0
; reads:   $F0FF60, the beam's position
; error:   returns if there is no UAE ($F0FF60 reads zero)
; cost:    two fields at most

; A separate command, so that the programs stay ordinary Amiga programs.

        include "amiga.i"
        include "uae.i"

        xref    exact_set
        xdef    start
        section .text.start,code
start:
        tst.l   UAE_TRAP
        beq.s   .absent
        cmpi.b  #'e',(a0)
        beq.s   .exact
        pea     UAE_EXIT
        jsr     UAE_TRAP
        addq.l  #4,sp
.absent moveq   #0,d0
        rts
.exact  moveq   #1,d0
        jsr     exact_set
        lea     custom,a0
.lower  btst    #0,vposr+1(a0)          ; to a line above 255, then to the next field's first one
        beq.s   .lower
.upper  btst    #0,vposr+1(a0)
        bne.s   .upper
        moveq   #0,d0
        rts
