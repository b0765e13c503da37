; Packed texture coordinates of the addx form (see c/span/scanline.h).
; Bytes: capitals integer, small letters fraction.
;
; A coordinate pair lives in three registers, S, Q and P:
;       S   uu..        Q   v--U        P   ..Vv
; One step is add.l S, addx.l Q, addx.w P: u's fraction carries into U, v's low
; fraction byte into Vv. The bytes marked -- catch U's overflow.

        include "routine.i"

; Packs u (\1) and v (\2), both 16.16, into S (\1, lower word 0), Q (\3) and P (\2's
; lower word; its upper word is left over).
pack_uv macro
        moveq   #0,\3
        move.b  \2,\3
        ror.l   #8,\3                   ; v---
        lsr.l   #8,\2                   ; -.Vv
        swap    \1                      ; uuUU
        move.b  \1,\3                   ; v--U
        clr.w   \1                      ; uu--
        endm

; Packs u (\1) and v (\2), both 16.16, into the start of the line \4. Uses \3.
pack_start macro
        pack_uv \1,\2,\3
        swap    \1
        move.w  \1,scanline_start0(\4)
        move.w  \2,scanline_start1(\4)
        move.l  \3,scanline_start2(\4)
        endm

; Adds \2 (sign-extended) to the step \1 = uu--, so that one addition steps both. A
; negative \2 borrows from uu; the carry out of the lower half returns that. If uu is 0,
; that carry continues into \3, u's integer, so \3 is decremented (\4: the integer's
; size in \3, b, w or l).
add_below macro
        tst.l   \2
        bpl.s   .forward\@
        tst.l   \1
        bne.s   .forward\@
        subq.\4 #1,\3
.forward\@
        add.l   \2,\1
        endm

; Packs the steps d2 (u) and d5 (v), 16.16, for the chain of two registers (see
; span_affine_addx): d2 uuVv, d3 v--U, a4 v---. A v that goes down borrows a unit of u, which the carry out of Vv
; returns. Uses d5.
chain_steps macro
        moveq   #0,d3
        move.b  d5,d3
        ror.l   #8,d3                   ; v---
        movea.l d3,a4
        lsr.l   #8,d5                   ; .Vv
        tst.w   d5
        minus   <subq.l #1,d2>
        swap    d2                      ; uuUU
        move.b  d2,d3                   ; v--U
        move.w  d5,d2                   ; uuVv
        endm

; Packs a step \1 (16.16) for a chain of one register, which carries into itself:
; \1 = ss-S, with a spare byte above S; \2 = \3 = ss-0. A start is ss-S with \2's spare
; byte, plus \3: its fraction is one step ahead, so that its carry is ready when S is
; stepped. The spare byte is 00 if the step is not negative: S never carries into ss.
; Otherwise it is FF: S always carries, and the step of ss is one less.
pack_alone macro
        swap    \1
        ext.w   \1                      ; ss-S
        bpl.s   .packed\@
        borrow  \1,1<<16,w
.packed\@
        ahead   \1,\2,\3,b
        endm

; Decrements the fraction of a negative step \1; \2 is the fraction's lowest bit. If the
; fraction is 0, the integer (\3: w or l) is decremented, and the fraction always carries.
borrow  macro
        sub.l   #\2,\1
        bcc.s   .borrowed\@
        subq.\3 #1,\1
.borrowed\@
        endm

; \2 = \3 = the fraction of the step \1, which starts are ahead by: \1 with the integer
; in its lower \4 (b or w) cleared.
ahead   macro
        move.l  \1,\2
        clr.\4   \2
        movea.l \2,\3
        endm

; For coordinates stepped by add and swap: d4 = uuVU of u (d0 = -Uuu) and v (d1 = Vvv-), which is
; held 8 bits higher than u. \1: a register with $00ffffff. 10 bytes.
join_uv macro
        move.l  d1,d4
        eor.l   d0,d4
        and.l   \1,d4
        eor.l   d1,d4                   ; VUuu
        swap    d4
        endm

; Pixels of spans: d4 holds the map's page in its upper word, (a1)+ is the destination.
; texel_next makes d4 the texel's address and steps the coordinates; a2 is free. Its arguments are
; registers with steps, d2 and d3 unless the steps change from pixel to pixel.

; The chain of two registers: B in d0, A in d1, their steps in \1 and \2. 8 bytes.
texel_next macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        addx.l  \1,d0
        addx.l  \2,d1
        endm

; S, Q and P in d5, d1 and d0, their steps in a4, \2 and \1: P is stepped as a word, so
; V's overflow is lost instead of entering u. 10 bytes.
texel_next_apart macro
        move.w  d0,d4                   ; mmVv
        move.b  d1,d4                   ; mmVU
        add.l   a4,d5
        addx.l  \2,d1
        addx.w  \1,d0
        endm

; Draws the texel at d4. 4 bytes.
draw    macro
        movea.l d4,a2
        move.b  (a2),(a1)+
        endm

; Draws the texel at d4 through a row of the light table; the texel becomes the lowest
; byte of the row's address \1. 8 bytes.
draw_lit macro
        movea.l d4,a2
        move.b  (a2),\1
        movea.l \1,a2
        move.b  (a2),(a1)+
        endm

pixel_chain macro
        texel_next d2,d3
        draw
        endm

pixel_apart macro
        texel_next_apart d2,d3
        draw
        endm

; Draws a pixel and steps u alone, in a chain of one register: u in d0, its step in d2.
; 8 bytes.
pixel_row macro
        move.b  d0,d4                   ; mmVU
        addx.l  d2,d0
        draw
        endm

; Draws a shade as the pixel and steps it as pixel_row does u. 4 bytes.
pixel_shade macro
        move.b  d0,(a1)+
        addx.l  d2,d0
        endm

; A chain of three registers d0-d2, their steps in d3-d5: \1 ..Vv, d1 --U, \2 ..Cc, the
; level of light. The map's page in d6, the light table's in d7. 20 bytes.
pixel_lit macro
        move.w  \1,d6                   ; mmVv
        move.b  d1,d6                   ; mmVU
        movea.l d6,a2
        move.w  \2,d7                   ; llCc
        move.b  (a2),d7                 ; ll, C and the texel
        addx.l  d3,d0
        addx.l  d4,d1
        addx.l  d5,d2
        movea.l d7,a2
        move.b  (a2),(a1)+
        endm

; Draws a texel of \1 = 2 or 4 bytes. a3 is texel (0, 0) of the map; rows 128 to 255 are
; before it, as d4 = VU is signed. 4 bytes.
draw_wide macro
        ifeq    \1-2
        move.w  (a3,d4.w*2),(a1)+
        else
        move.l  (a3,d4.w*4),(a1)+
        endc
        endm

; Opens a span with the chain of two registers (see span_open), d5 = the pitch. If \1 is given, it is another
; field of the plan to push, on the pitch, which is not in d5.
chain_open macro
        ifnb    \1
        span_open
        move.l  span_plan_\1(a0),-(sp)
        else
        span_begin
        endc
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_dudx(a0),d2
        move.l  span_plan_dvdx(a0),d5
        ifb     \1
        movea.l span_plan_pitch(a0),a2
        endc
        span_table
        chain_steps
        ifb     \1
        move.l  a2,d5
        endc
        endm

; Opens a span with S, Q and P in separate registers. \1: as in chain_open.
apart_open macro
        span_open
        move.l  span_plan_map(a0),d4    ; mm00
        ifnb    \1
        move.l  span_plan_\1(a0),-(sp)
        endc
        move.l  span_plan_dudx(a0),d5
        move.l  span_plan_dvdx(a0),d2
        span_table
        apart_steps
        endm

; Packs the steps d5 (u) and d2 (v), 16.16, for S, Q and P.
apart_steps macro
        pack_uv d5,d2,d3                ; d5 uu--, d2 .Vv, d3 v--U
        movea.l d5,a4
        endm

; d5 = S of a line, from its start0:start1 in d0.
apart_start macro
        move.l  d0,d5                   ; uu.. (Vv below it is never carried)
        clr.w   d5
        endm

; Opens a span with one coordinate. d2 = its step, the plan's field \1.
alone_open macro
        span_open
        move.l  span_plan_map(a0),d4    ; mm00
        move.l  span_plan_\1(a0),d2
        span_table
        endm
