        include "routine.i"
        include "layout.i"
        include "chain.i"
        include "span.i"
        include "dither.i"

;==============================================================================
; span_dithered_16 - span_dithered with 16-bit texels and pixels
;
; in:      a0  span_plan*  the table, the frame, the map, the steps, odd
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v--U), the map
; writes:  the pixels of the lines, nothing else
; formats: as span_dithered, with the 16-bit texels and pixels of span_affine_16
; error:   none, as span_dithered
; cost:    bench row dithered_16
;==============================================================================

        routine span_dithered_16,a0
        dither_chain_open
        movea.l d4,a3
        dither_chain_lines draw_wide,2,*2,pc
