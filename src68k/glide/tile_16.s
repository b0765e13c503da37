        include "glide.i"

; glide_tile_16 - pixels by point sampling of a page of 16-bit pixels
;
; in:      a0  const glide_iterators*  s and t at the first pixel
;          a1  uint16*  pixels
;          a2  const glide_paging*  the page, their steps
;          d0  int32  count, 16,384 at most
; formats: s and t times 2^left are 8.24: column and row of the page, modulo 256
; cost:    bench rows glide_tile_16, glide_bilinear_prefiltered_16
        pass    glide_tile_16
        glide_paged 2
