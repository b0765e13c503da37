        include "fields.i"

; glide_store_565 - texels into a 16-bit frame
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint16*  pixels, 5/6/5
;          a2  void*  not read
; formats: each channel's upper bits
        pass    glide_store_565
        fields_store $f800f800,$00fc0000,11
