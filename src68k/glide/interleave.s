        include "routine.i"

; glide_interleave - a line from four arrays with every fourth texel each
;
; in:      a0  const uint32*  texels 0, 4, 8, ...; the other arrays follow
;          a1  uint32*  texels
;          a2  const glide_quarters*  the bytes from one array to the next
;          d0  int32  count, of the line
; formats: texels of 32 bits, unchanged
        pass    glide_interleave
        movem.l a2-a4,-(sp)
        move.l  glide_quarters_bytes(a2),d1
        lea     (a0,d1.l),a2
        lea     (a2,d1.l),a3
        lea     (a3,d1.l),a4
        moveq   #3,d1
        and.l   d0,d1                   ; pixels of the last round
        lsr.l   #2,d0
        bra.s   .next
.pixels move.l  (a0)+,(a1)+
        move.l  (a2)+,(a1)+
        move.l  (a3)+,(a1)+
        move.l  (a4)+,(a1)+
.next   dbra    d0,.pixels
        subq.l  #1,d1
        bmi.s   .done
        move.l  (a0),(a1)+
        subq.l  #1,d1
        bmi.s   .done
        move.l  (a2),(a1)+
        subq.l  #1,d1
        bmi.s   .done
        move.l  (a3),(a1)+
.done   movem.l (sp)+,a2-a4
        rts
