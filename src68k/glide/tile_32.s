        include "glide.i"

; glide_tile_32 - pixels by point sampling of a page of 32-bit pixels
;
; like:    glide_tile_16
; in:      a1  uint32*  pixels
; cost:    bench rows glide_tile_32, glide_bilinear_prefiltered
        pass    glide_tile_32
        glide_paged 4
