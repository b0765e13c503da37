        include "glide.i"

;==============================================================================
; glide_tile_32 - pixels by point sampling of a page of 32-bit pixels
;
; like:    glide_tile_16
; in:      a0  const glide_iterators*  s and t at the first pixel
;          a1  uint32*  pixels
;          a2  const glide_paging*  the page, their steps
;          d0  int32  count, 16,384 at most
; cost:    bench rows glide_tile_32, glide_bilinear_prefiltered
;==============================================================================
        pass    glide_tile_32
        glide_paged 4
