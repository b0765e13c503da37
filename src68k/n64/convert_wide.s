        include "n64.i"

; n64_convert_wide - YUV texels as inputs of the combiner
;
; like:    n64_convert
; in:      a1  n64_wide*  R, G, B, A = Y
; formats: 9 bits as the combiner takes them: -128 to 383
        pass    n64_convert_wide
        n64_convert_open
        move.w  #128,d5
        move.w  #255,d6
        move.w  #511,d7
.pixels n64_converted
        add.w   d5,d1
        add.w   d5,d2
        add.w   d5,d3
        and.w   d7,d1
        and.w   d7,d2
        and.w   d7,d3
        sub.w   d5,d1
        sub.w   d5,d2
        sub.w   d5,d3
        swap    d1
        move.w  d2,d1
        move.l  d1,(a1)+
        swap    d3
        move.w  d0,d3
        move.l  d3,(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        return_all
