        include "n64.i"

; n64_divide - coordinates with perspective
;
; in:      a0  const n64_iterators*  at the first pixel
;          a1  n64_coordinates*  coordinates
;          a2  const n64_division*  their steps, the table of reciprocals
; formats: s15.16 modulo 2^32, their upper words divided; the results clamped to s10.5,
;          32,767 if w is not above 0

; s * 65536 * reciprocal: the upper half of the product is the quotient. n64_guard shows lines where
; no quotient is clamped; these take the shorter loop.

        pass    n64_divide
        save_all
        move.l  #N64_GUARD,d4
        n64_guard .any
        bsr.s   .begin
        swap    d2
        move.l  a6,d7
        move.l  a6,d6
        swap    d7
        swap    d6                      ; --II
        clr.w   d7                      ; ff--
.inside move.l  (a3,d2.w*4),d3
        move.l  d0,d4
        clr.w   d4
        muls.l  d3,d5:d4
        move.l  d1,d4
        clr.w   d4
        muls.l  d3,d3:d4
        swap    d5
        move.w  d3,d5
        move.l  d5,(a1)+
        add.l   a4,d0
        add.l   a5,d1
        add.l   d7,d2
        addx.w  d6,d2
        cmpa.l  a0,a1
        bne.s   .inside
        return_all

        ; The registers of both loops. In: d0 count.
.begin  lea     (a1,d0.l*4),a3
        movem.l (a0),d0-d2
        movem.l (a2),a4-a6
        movea.l a3,a0
        movea.l n64_division_reciprocals(a2),a3
        rts

.any    bsr.s   .begin
.pixels move.l  d2,d3
        swap    d3
        tst.w   d3
        ble.s   .bad
        move.l  (a3,d3.w*4),d3
        move.l  d0,d4
        clr.w   d4
        muls.l  d3,d5:d4
        move.l  d1,d4
        clr.w   d4
        muls.l  d3,d6:d4
        movea.w d5,a2
        cmpa.l  d5,a2
        bne.s   .far_s
.s      movea.w d6,a2
        cmpa.l  d6,a2
        bne.s   .far_t
.t      swap    d5
        move.w  d6,d5
.write  move.l  d5,(a1)+
        add.l   a4,d0
        add.l   a5,d1
        add.l   a6,d2
        cmpa.l  a0,a1
        bne.s   .pixels
        return_all
.bad    move.l  #$7fff7fff,d5
        bra.s   .write
.far_s  n64_nearest d5
        bra.s   .s
.far_t  n64_nearest d6
        bra.s   .t
