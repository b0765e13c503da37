        include "routine.i"

; glide_lod - each pixel's level of detail, by its w
;
; in:      a0  const glide_iterators*  w at the first pixel
;          a1  uint16*  LODs
;          a2  const glide_lods*  the step of w, the polygon's LOD, limits, logarithms
; writes:  the LODs: level in the upper byte, fraction in the lower one
; formats: w 2.30 modulo 2^32; LODs 8.8: lods of the pixel - 256 log2 |w|, the logarithm rounded
;          to the nearest, clamped to least to most; most if w is 0

; w is kept shifted so that bit 31 is set, its step likewise; a clear bit 31 needs a new shift.

        pass    glide_lod
        save_all
        lea     (a1,d0.l*2),a5          ; end
        move.l  glide_iterators_w(a0),d0
        movea.l glide_lods_w(a2),a0
        movea.l glide_lods_logarithms(a2),a3
        movea.w glide_lods_least(a2),a4
        movea.w glide_lods_most(a2),a6
        moveq   #0,d6                   ; of the pixel's lods
        bra.s   .find

.low    move.w  a4,d3
        bra.s   .write
.high   move.w  a6,d3
        bra.s   .write
.pixel  bfextu  d2{1:9},d4
        move.w  d7,d3
        add.w   (a2,d6.w),d3
        move.l  (a3,d4.w*8),d1
        sub.l   d2,d1                   ; X if the logarithm is one more
        move.w  glide_logarithm_value(a3,d4.w*8),d1
        subx.w  d1,d3
        cmp.w   a4,d3
        blt.s   .low
        cmp.w   a6,d3
        bgt.s   .high
.write  move.w  d3,(a1)+
        cmpa.l  a5,a1
        beq.s   .done
        addq.w  #2,d6
        and.w   #6,d6
        add.l   a0,d0
        add.l   d5,d2
        bmi.s   .pixel

        ; d2 = |w|, d5 = its step, both shifted; d7 = 256 * the shift
.find   moveq   #0,d5
        move.l  d0,d2
        beq.s   .high
        move.l  a0,d5
        tst.l   d2
        minus   <neg.l d2>,<neg.l d5>
        bfffo   d2{0:0},d7
        lsl.l   d7,d2
        move.l  d5,d4
        lsl.l   d7,d5
        move.l  d5,d3
        asr.l   d7,d3
        lsl.w   #8,d7
        cmp.l   d4,d3
        beq.s   .pixel
        move.l  #$80000000,d5           ; does not fit: find the shift again at the next pixel
        bra.s   .pixel
.done   return_all
