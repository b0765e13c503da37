        include "keyed.i"

; span_keyed_rows - span_keyed_row for the lines of edge_opaque, some of which have no transparent texel
;
; like:    span_keyed_row
; reads:   the plan, its lines (start0 = uu, start1 = Vv, start2 = v-tU; t: 1 if texels may be 0), the map

        span span_keyed_rows
        keyed_row_line
        btst    #8,d1
        beq     .opaque
        add.l   a4,d0
        span_enter 4
        keyed_round row_next,d2
        span_close d3
        keyed_passes
.opaque add.l   a4,d0
        jmp     .texels_end-8(pc,d6.w*8)
.texels rept    8
        pixel_row
        endr
.texels_end
        dbra    d7,.texels
        bra     .line_next
