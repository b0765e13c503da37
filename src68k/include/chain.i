; Packed texture coordinates of the addx form (see c/span/scanline.h).
; Bytes: capitals integer, small letters fraction.
;
; A coordinate pair lives in three registers, S, Q and P:
;       S   uu..        Q   v--U        P   ..Vv
; One step is add.l S, addx.l Q, addx.w P: u's fraction carries into U, v's low
; fraction byte into Vv. The bytes marked -- catch what U overflows.

; Packs u (\1) and v (\2), both 16.16, into S (\1, lower word 0), Q (\3) and P (\2's
; lower word; its upper word is left over).
pack_uv macro
        move.l  \2,\3
        and.l   #$ff,\3
        ror.l   #8,\3                   ; v---
        lsr.l   #8,\2                   ; -.Vv
        swap    \1                      ; uuUU
        move.b  \1,\3                   ; v--U
        clr.w   \1                      ; uu--
        endm

; Adds the number \2 (sign-extended) to the step \1 = uu--, so that one addition moves
; both. A negative \2 borrows from uu, which the carry out of the lower half pays back;
; with nothing to borrow from, that carry goes on into \3, u's integer: \3 is made one
; less (\4: b or w, how much of \3 the integer has).
add_below macro
        tst.l   \2
        bpl.s   .forward\@
        tst.l   \1
        bne.s   .forward\@
        subq.\4 #1,\3
.forward\@
        add.l   \2,\1
        endm

; The steps d2 (u) and d5 (v), 16.16, as those of the chain of two registers (see
; span_affine_addx): d2 uuVv, d3 v--U, a4 v---. Uses d0/d5.
chain_steps macro
        pack_uv d2,d5,d3                ; d2 uu--, d5 .Vv, d3 v--U
        ext.l   d5
        add_below d2,d5,d3,b            ; uuVv
        move.l  d3,d0
        clr.w   d0
        movea.l d0,a4                   ; v---
        endm

; Packs a step (\1, 16.16) that is carried into itself into ss-S, S with a byte of room
; above it, and \3 = ss-0; \2 holds that too. A start is ss-S with \2's room, plus \3:
; its fraction runs one step ahead, so that the carry it gave is ready when S needs it.
; Room is 00 with a step from 0 on: S never carries into ss. With a negative one it is
; FF: S always does, and the step of ss is one less.
pack_alone macro
        swap    \1
        ext.w   \1                      ; ss-S
        bpl.s   .packed\@
        sub.l   #$10000,\1
        bcc.s   .packed\@
        subq.w  #1,\1                   ; nothing to borrow from: ss always carries
.packed\@
        move.l  \1,\2
        clr.b   \2
        movea.l \2,\3
        endm

; A pixel of 14 bytes with S, Q and P in d5, d1 and d0, their steps in a4, d3 and d2,
; the map's page in d4: P is stepped as a word, so V's overflow is lost instead of
; entering u.
pixel_apart macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        add.l   a4,d5
        addx.l  d3,d1
        addx.w  d2,d0
        movea.l d4,a2
        move.b  (a2),(a1)+
        endm
