        include "n64.i"

; n64_convert - colours of YUV texels
;
; in:      a0  const uint32*  texels, Y the last byte
;          a1  uint32*  colours, R G B A
;          a2  const n64_yuv_conversion*  U and V, tables
; formats: 9 bits each of R, G, B and A = Y are the indices of the colours' channels
        pass    n64_convert
        n64_convert_open
        movea.l n64_yuv_conversion_colours(a2),a2
        move.w  #255,d6
        move.w  #511,d7
.pixels n64_converted
        and.w   d7,d1
        and.w   d7,d2
        and.w   d7,d3
        move.b  (a2,d1.w*4),d1
        lsl.w   #8,d1
        move.b  1(a2,d2.w*4),d1
        swap    d1
        move.b  2(a2,d3.w*4),d1
        lsl.w   #8,d1
        move.b  3(a2,d0.w*4),d1
        move.l  d1,(a1)+
        cmpa.l  a6,a0
        bne.s   .pixels
        return_all
