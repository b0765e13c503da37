; Parts shared by the chunky to planar routines.
;
; Five index bits number the 32 bits of a register, three more number eight registers. A merge
; exchanges one of the five with one of the three.

        include "routine.i"

; Kept on the stack:
BACK    equ     0                       ; from plane 3's next longword to plane 0's
END     equ     4                       ; of the row's pixels
ROWS    equ     8
ROW     equ     12                      ; bytes of its pixels
NEXT    equ     16                      ; from their end to the next row's
NEXT_PLANE equ  20                      ; the same of the planes
LOCALS  equ     24

; Takes the plan in a0; after it a0 is the pixels, a1 plane 0, a2 the plane pitch and d5-d7
; have masks. A pixel has 1 << \1 bytes; a row has 1 << \2 times as many as a plane's row.
planar_open macro
        save_all
        lea     -LOCALS(sp),sp
        move.l  planar_plan_width(a0),d0
        ifne    \1
        lsl.l   #\1,d0
        endc
        move.l  d0,ROW(sp)
        move.l  planar_plan_pitch(a0),d1
        sub.l   d0,d1
        move.l  d1,NEXT(sp)
        lsr.l   #\2,d0
        move.l  planar_plan_row_pitch(a0),d1
        sub.l   d0,d1
        move.l  d1,NEXT_PLANE(sp)
        movea.l planar_plan_plane_pitch(a0),a2
        moveq   #4,d0
        sub.l   a2,d0
        sub.l   a2,d0
        sub.l   a2,d0
        move.l  d0,BACK(sp)
        move.l  planar_plan_rows(a0),ROWS(sp)
        movea.l planar_plan_planes(a0),a1
        movea.l planar_plan_pixels(a0),a0
        move.l  #$00ff00ff,d5
        move.l  #$33333333,d6
        move.l  #$55555555,d7
        endm

; Begins a row. The loop must follow: it is aligned to the lines of the instruction cache.
planar_row macro
.row    move.l  a0,d0
        add.l   ROW(sp),d0
        move.l  d0,END(sp)
        bra.s   .longs
        cnop    0,4
        endm

; Ends the loop and the row.
planar_next macro
        adda.l  BACK(sp),a1
        move.l  #$00ff00ff,d5
        cmpa.l  END(sp),a0
        bne     .longs
        adda.l  NEXT(sp),a0
        adda.l  NEXT_PLANE(sp),a1
        subq.l  #1,ROWS(sp)
        bne     .row
        lea     LOCALS(sp),sp
        return_all
        endm

; Begins a row of a loop whose planes' places are a1, a3, a4 and a5; the end of its pixels is in a6. \1: bytes on the
; stack above planar_open's.
places_row macro
.row    movea.l a0,a6
        adda.l  ROW+\1(sp),a6
        cnop    0,4                     ; by nops
        endm

; Ends that loop and the row; \1: the same, \2: where the rows are counted.
places_next macro
        cmpa.l  a6,a0
        bne     .longs
        adda.l  NEXT+\1(sp),a0
        move.l  NEXT_PLANE+\1(sp),d0
        adda.l  d0,a1
        adda.l  d0,a3
        adda.l  d0,a4
        adda.l  d0,a5
        subq.l  #1,\2+\1(sp)
        bne     .row
        endm

; 16 pixels from a0 on as words 8 bytes apart: d0 the first words and d1 the second ones, d2 and d3 those 4 bytes behind
; them.
words_16 macro
        move.l  (a0)+,d0
        move.l  d0,d1
        swap    d1
        move.w  4(a0),d0
        move.w  6(a0),d1
        move.l  (a0)+,d2
        move.l  d2,d3
        swap    d3
        move.w  4(a0),d2
        move.w  6(a0),d3
        addq.l  #8,a0
        endm

; The body of a conversion to eight half planes. Without the merge by 2, bit 1 of a pixel's number meets no other bit: even
; words of the frame and odd ones are converted one after the other, by four registers. Merges exchange its bit 4 and bit
; 1's place (by words), 3 and 0, 2 and the plane's bit 2, and, if \1 is 1, 0 and the plane's bit 0.
half_planes macro
HELD    set     12                      ; bytes on the stack above planar_open's
        planar_open 0,3
        move.l  #$0f0f0f0f,d6
        movem.l a0/a1,-(sp)
        bsr.s   half
        movem.l (sp),a0/a1
        addq.l  #2,a0
        lea     (a1,a2.l*2),a1
        bsr.s   half
        lea     LOCALS+8(sp),sp
        return_all

; Words from a0 on, 4 bytes apart, to a1 and half planes behind it.
half    move.l  ROWS+HELD(sp),BACK+HELD(sp)
        lea     (a1,a2.l),a3
        lea     (a1,a2.l*4),a4
        lea     (a3,a2.l*4),a5
        places_row HELD
.longs  movem.l (a0)+,d0-d3
        move.w  (a0),d0
        move.w  4(a0),d1
        move.w  8(a0),d2
        move.w  12(a0),d3
        lea     16(a0),a0
        merge   d0,d2,8,d5
        merge   d1,d3,8,d5
        merge   d0,d1,4,d6
        ifne    \1
        merge   d2,d3,4,d6
        merge   d0,d2,1,d7
        move.l  d0,(a5)+
        merge   d1,d3,1,d7
        move.l  d2,(a4)+
        move.l  d1,(a3)+
        else
        move.l  d0,(a5)+
        merge   d2,d3,4,d6
        move.l  d1,(a3)+
        move.l  d2,(a4)+
        endc
        move.l  d3,(a1)+
        places_next HELD,BACK
        rts
        endm

; The body of a conversion of pixels two dots wide to four half planes; \1: 1 if they are merged by 2.
wide_halves macro
        planar_open 0,2
        move.l  #$0f0f0f0f,d7
        lea     (a1,a2.l),a3
        lea     (a1,a2.l*2),a4
        lea     (a3,a2.l*2),a5
        places_row 0
.longs  words_16
        merge   d0,d2,8,d5
        merge   d1,d3,8,d5
        merge   d0,d1,4,d7
        ifne    \1
        merge   d2,d3,4,d7
        merge   d0,d2,2,d6
        move.l  d0,(a5)+
        merge   d1,d3,2,d6
        move.l  d2,(a4)+
        move.l  d1,(a3)+
        move.l  d3,(a1)+
        else
        move.l  d0,(a4)+
        merge   d2,d3,4,d7
        move.l  d1,(a1)+
        move.l  d2,(a5)+
        move.l  d3,(a3)+
        endc
        places_next 0,ROWS
        lea     LOCALS(sp),sp
        return_all
        endm

; Exchanges the bits of \1 in the mask \4 with those of \2 that are \3 to the left. Trashes d4.
merge   macro
        move.l  \2,d4
        lsr.l   #\3,d4
        eor.l   \1,d4
        and.l   \4,d4
        eor.l   d4,\1
        ifeq    \3-1
        add.l   d4,d4
        else
        lsl.l   #\3,d4
        endc
        eor.l   d4,\2
        endm

; Two longwords 16 bytes apart: both left words to \1, both right ones to \2.
words   macro
        move.l  \3(a0),\1
        move.l  \1,\2
        swap    \2
        move.w  \3+16(a0),\1
        move.w  \3+18(a0),\2
        endm

; Keeps the first half of a group until the second half has been merged as far.
keep_half macro
        movea.l d3,a3
        movea.l d1,a4
        movea.l d2,a5
        movea.l d0,a6
        endm

; The last merge, of the first half's \1 and the second half's \2: writes the plane at a1
; and the fourth plane after it. d5 = $f0f0f0f0. Register instructions follow each store,
; so that they run while chip RAM is written.
two_planes macro
        move.l  \1,d4
        lsl.l   #4,d4
        eor.l   \2,d4
        and.l   d5,d4
        eor.l   d4,\2
        move.l  \2,(a1)
        lsr.l   #4,d4
        move.l  \1,\2
        eor.l   d4,\2
        move.l  \2,(a1,a2.l*4)
        endm
