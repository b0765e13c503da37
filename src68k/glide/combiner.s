        include "routine.i"

; glide_combiner - one channel of the combine unit, any function
;
; in:      a0  void*  not read
;          a1  uint8*  the channel of the results, one texel a pixel
;          a2  const glide_inputs*  the inputs
; writes:  a byte of each pixel
; formats: factor m, inverted by flip: ((other - local) * (m + 1) >> 8) + added, clamped to 0 to
;          255, inverted by invert
        pass    glide_combiner
        save_all
        lea     (a1,d0.l*4),a6
        move.w  glide_inputs_invert(a2),-(sp)
        movem.l glide_inputs_other_step(a2),d4-d7
        movea.l glide_inputs_added(a2),a5
        movea.l glide_inputs_factor(a2),a4
        movea.l glide_inputs_other(a2),a0
        move.w  glide_inputs_flip(a2),d3
        movea.l glide_inputs_local(a2),a2
        moveq   #0,d0
        moveq   #0,d1
.pixels moveq   #0,d2
        move.b  (a4),d2
        adda.l  d6,a4
        move.b  (a0),d0
        adda.l  d4,a0
        move.b  (a2),d1
        adda.l  d5,a2
        eor.b   d3,d2
        addq.w  #1,d2
        sub.w   d1,d0
        muls.w  d2,d0
        asr.l   #8,d0
        move.b  (a5),d1
        adda.l  d7,a5
        add.w   d1,d0
        cmp.w   #255,d0
        bhi.s   .out
.in     move.w  (sp),d2
        eor.b   d2,d0
        move.b  d0,(a1)
        moveq   #0,d0
        addq.l  #4,a1
        cmpa.l  a6,a1
        bne.s   .pixels
        addq.l  #2,sp
        return_all
.out    tst.w   d0
        spl     d0
        bra.s   .in
