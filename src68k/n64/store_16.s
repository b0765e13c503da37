        include "fields.i"

; n64_store_16 - texels into a 16-bit frame
;
; in:      a0  const uint32*  texels, R G B A
;          a1  uint16*  pixels, 5/5/5/1
;          a2  void*  not read
; formats: channels >> 3, alpha >> 7
        pass    n64_store_16
        fields_store $f800f800,$00f80080,10
