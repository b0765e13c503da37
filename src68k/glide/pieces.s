        include "pieces.i"

; glide_pieces - a level's coordinates with perspective, divided at the ends of pieces
;
; like:    glide_divide
; in:      a0  const glide_iterators*  at the first pixel of the run's first piece
;          a2  const glide_steps*  their steps, the level, the piece
; formats: 14.18 and 2.30 modulo 2^32 to s:t. Quotients of 32 bits, as glide_divide has them, at a
;          piece's first pixel and at the next piece's, or at the line's last one; from the first
;          on, pixel by pixel, their difference modulo 2^32 over the pixels between them, rounded
;          down; then (value >> shift) - half, clamped to 0 to last_s, or modulo 2^16 if that is
;          0xffff
; cost:    bench rows glide_pieces, glide_pieces_16, glide_pieces_clamp, glide_pieces_small

; A piece ends where the next one begins, so each costs two quotients. Its pixels are stepped as in
; glide_walk, also on a clamped axis if both ends are inside: with a step of 2^28 at most, a piece
; covers less than half of the range of 32 bits.

; On the stack.
piece   equ     0                       ; the steps of s, t and w over a whole piece
whole   equ     12                      ; pieces to do
bits    equ     16
scale   equ     20                      ; 16 - shift; -1 if an axis is clamped
count   equ     24                      ; pixels to do, from the piece on
left    equ     28                      ; of the line
skip    equ     32
steps   equ     36
drawn   equ     40                      ; pixels of a part
length  equ     44                      ; pixels from a part's first quotients to the next
shift   equ     48
half    equ     52
last_s  equ     56                      ; 2^32 - 1: wrapped
last_t  equ     60
clamps  equ     64                      ; 0: no axis
locals  equ     68

        pass    glide_pieces
        save_all
        lea     -locals(sp),sp
        move.l  d0,count(sp)
        move.l  a2,steps(sp)
        move.l  glide_steps_left(a2),d1
        bne.s   .known
        move.l  d0,d1
.known  move.l  d1,left(sp)
        moveq   #0,d0
        move.w  glide_steps_skip(a2),d0
        move.l  d0,skip(sp)
        moveq   #0,d1
        move.w  glide_steps_bits(a2),d1
        move.l  d1,bits(sp)
        movem.l (a0),a3-a5
        movem.l (a2),d2-d4
        lsl.l   d1,d2
        lsl.l   d1,d3
        lsl.l   d1,d4
        movem.l d2-d4,piece(sp)
        moveq   #0,d2
        move.w  glide_steps_half(a2),d2
        move.l  d2,half(sp)
        swap    d2
        movea.l d2,a6
        glide_last glide_steps_last_s,last_s(sp),d2
        glide_last glide_steps_last_t,last_t(sp),d2
        moveq   #0,d3
        move.w  glide_steps_shift(a2),d3
        move.l  d3,shift(sp)
        moveq   #16,d4
        sub.l   d3,d4
        moveq   #-1,d2
        move.l  glide_steps_last_s(a2),d3       ; and last_t
        not.l   d3
        move.l  d3,clamps(sp)
        bne.s   .form
        move.l  d4,d2
.form   move.l  d2,scale(sp)
        movea.l a2,a0
        moveq   #4,d2
        lsl.l   d1,d2
        movea.l d2,a2                   ; bytes of a whole piece
        bsr     .ends
        move.l  d0,d6                   ; of the piece's first pixel
        move.l  d1,d7
        tst.l   skip(sp)
        bne     .part

.pieces move.l  count(sp),d0
        beq     .done
        move.l  left(sp),d1
        subq.l  #1,d1
        move.l  bits(sp),d4
        lsr.l   d4,d0
        lsr.l   d4,d1
        cmp.l   d0,d1
        bhs.s   .least
        move.l  d1,d0
.least  move.l  d0,whole(sp)
        beq     .part
        lsl.l   d4,d0
        sub.l   d0,count(sp)
        sub.l   d0,left(sp)
        bra     .piece

        ; Writes up to a0, 4 pixels a round.
.narrow movem.l d6-d7/a3,-(sp)
        move.l  shift+12(sp),d7
        moveq   #-16,d6
        add.l   d7,d6
        movea.l half+12(sp),a3
        move.l  a1,d4
        sub.l   a0,d4
        and.w   #12,d4                  ; bytes the first round lacks
        move.w  d4,d5
        lsl.w   #2,d4
        add.w   d5,d4
        jmp     .fours(pc,d4.w)
.fours  rept    4
        move.l  d0,d4                   ; 20 bytes
        asr.l   d6,d4
        move.l  d1,d5
        asr.l   d7,d5
        sub.l   a6,d4
        sub.w   a3,d5
        add.l   d2,d0
        move.w  d5,d4
        add.l   d3,d1
        move.l  d4,(a1)+
        endr
        cmpa.l  a0,a1
        bne.s   .fours
        movem.l (sp)+,d6-d7/a3
        subq.l  #1,whole(sp)
        beq     .pieces

.piece  adda.l  piece(sp),a3
        adda.l  piece+4(sp),a4
        adda.l  piece+8(sp),a5
        move.l  a5,d3
        ble     .odd
        quotients .odd
.ended  move.l  bits(sp),d4
        move.l  d0,d2
        move.l  d1,d3
        sub.l   d6,d2
        sub.l   d7,d3
        exg     d0,d6
        exg     d1,d7
        asr.l   d4,d2
        asr.l   d4,d3
        lea     (a1,a2.l),a0
        move.l  scale(sp),d5
        bmi     .other
.scale  scaled
.pixels rept    8
        move.l  d0,d4                   ; 12 bytes
        move.w  d1,d4
        add.l   d2,d0
        add.l   d3,d1
        addx.w  d5,d1
        move.l  d4,(a1)+
        endr
        cmpa.l  a0,a1
        bne.s   .pixels
.next   subq.l  #1,whole(sp)
        bne     .piece
        bra     .pieces

        ; Pieces that may need clamping, or whose coordinates have more than 16 fraction bits.
.other  tst.l   clamps(sp)
        beq     .narrow
        move.l  bits(sp),d5
        at_end  d0,d2
        move.l  shift(sp),d5
        inside  last_s(sp)
        move.l  d0,d4
        inside  last_s(sp)
        move.l  bits(sp),d5
        at_end  d1,d3
        move.l  shift(sp),d5
        inside  last_t(sp)
        move.l  d1,d4
        inside  last_t(sp)
        neg.l   d5
        add.l   #16,d5
        bpl     .scale

        ; Writes up to a0, pixel by pixel as glide_walk_clamp.
.single movem.l d6-d7/a3-a4,-(sp)
        movea.l last_s+16(sp),a3
        movea.l last_t+16(sp),a4
        move.l  shift+16(sp),d6
        move.l  half+16(sp),d7
        glide_clamp_pixels
        movem.l (sp)+,d6-d7/a3-a4
        bra     .next
        glide_clamp_outside

.odd    movea.l steps(sp),a0
        bsr     .both
        bra     .ended

        ; Part of a piece.
.part   movea.l steps(sp),a0
        move.l  a2,d4
        lsr.l   #2,d4
        move.l  d4,d2
        sub.l   skip(sp),d2
        cmp.l   count(sp),d2
        bls.s   .inside
        move.l  count(sp),d2
.inside move.l  d2,drawn(sp)
        sub.l   d2,count(sp)
        move.l  left(sp),d5
        sub.l   d4,left(sp)
        subq.l  #1,d5
        cmp.l   d4,d5
        bls.s   .last
        move.l  d4,d5
.last   move.l  d5,length(sp)
        move.l  d6,d0
        move.l  d7,d1
        moveq   #0,d2
        moveq   #0,d3
        tst.l   d5
        beq.s   .stays                  ; the line's last pixel
        cmp.l   d5,d4
        beq.s   .to_next
        movem.l (a0),d2-d4
        muls.l  d5,d2
        muls.l  d5,d3
        muls.l  d5,d4
        adda.l  d2,a3
        adda.l  d3,a4
        adda.l  d4,a5
        bsr     .ends
        move.l  length(sp),d5
        move.l  d0,d2
        move.l  d1,d3
        step    d2,d6
        step    d3,d7
        bra.s   .skip
.to_next
        adda.l  piece(sp),a3
        adda.l  piece+4(sp),a4
        adda.l  piece+8(sp),a5
        bsr     .ends
        move.l  bits(sp),d4
        move.l  d0,d2
        move.l  d1,d3
        sub.l   d6,d2
        sub.l   d7,d3
        asr.l   d4,d2
        asr.l   d4,d3
.skip   exg     d0,d6
        exg     d1,d7
        move.l  skip(sp),d5
        beq.s   .stays
        move.l  d2,d4
        muls.l  d5,d4
        muls.l  d3,d5
        add.l   d4,d0
        add.l   d5,d1
        clr.l   skip(sp)
.stays  move.l  drawn(sp),d4
        lea     (a1,d4.l*4),a0
        move.l  #1,whole(sp)
        tst.l   clamps(sp)
        bne     .single
        move.l  scale(sp),d5
        bmi     .narrow
        scaled
        move.l  drawn(sp),d4
        neg.l   d4
        and.l   #7,d4                   ; pixels the first round lacks
        move.l  d4,drawn(sp)
        add.l   d4,d4
        add.l   drawn(sp),d4
        jmp     .pixels(pc,d4.l*4)

.done   lea     locals(sp),sp
        return_all

        quotients_of_ends
