; A plain span routine, span_well, and wrong variants of it: each breaks the contract
; of span_affine_swap in one way. For the tests of
; the checker.

        include "routine.i"

WELL                    equ     0
TRASHES_D2              equ     1
WRITES_PAST             equ     2
WRITES_BEFORE           equ     3
SKIPS_LAST              equ     4
TEXEL_BESIDE            equ     5
LEAVES_STACK            equ     6
CHANGES_MAP             equ     7
CHANGES_LINES           equ     8
CHANGES_GUARD           equ     9
HANGS                   equ     10
ILLEGAL                 equ     11

; \1: name, \2: number of the fault
span    macro
        routine \1,a0
        movem.l d2-d7/a2-a6,-(sp)
        movea.l span_plan_lines(a0),a1
        move.l  span_plan_count(a0),d7
        movea.l span_plan_row(a0),a6
        movea.l span_plan_map(a0),a2
.line   move.w  scanline_left(a1),d0
        lea     (a6,d0.w),a3
        move.w  scanline_last(a1),d6
        sub.w   scanline_left(a1),d6
        addq.w  #1,d6
        ble     .next
        move.w  scanline_start1(a1),d2
        swap    d2
        move.w  scanline_start0(a1),d2  ; UUuu
        move.l  scanline_start2(a1),d3  ; VVvv
        ifeq    \2-WRITES_BEFORE
        not.b   -1(a3)
        endc
        ifeq    \2-TEXEL_BESIDE
        add.l   #$10000,d2
        endc
        ifeq    \2-SKIPS_LAST
        subq.w  #1,d6
        beq     .next
        endc
.pixel  moveq   #0,d0
        move.l  d3,d1                   ; VVvv
        swap    d1
        move.b  d1,d0
        lsl.w   #8,d0                   ; V-
        move.l  d2,d1                   ; UUuu
        swap    d1
        move.b  d1,d0                   ; VU
        move.b  (a2,d0.l),(a3)+
        add.l   span_plan_dudx(a0),d2
        add.l   span_plan_dvdx(a0),d3
        subq.w  #1,d6
        bne     .pixel
        ifeq    \2-WRITES_PAST
        not.b   (a3)
        endc
.next   ifeq    \2-CHANGES_LINES
        addq.l  #1,scanline_start2(a1)
        endc
        lea     scanline_sizeof(a1),a1
        adda.l  span_plan_pitch(a0),a6
        subq.l  #1,d7
        bne     .line
        ifeq    \2-CHANGES_MAP
        not.b   1234(a2)
        endc
        ifeq    \2-CHANGES_GUARD
        not.b   span_plan_sizeof+7(a0)
        endc
        ifeq    \2-HANGS
.hang   bra.s   .hang
        endc
        movem.l (sp)+,d2-d7/a2-a6
        ifeq    \2-TRASHES_D2
        moveq   #2,d2
        endc
        ifeq    \2-LEAVES_STACK
        move.l  (sp)+,(sp)              ; returns from one longword higher
        endc
        ifeq    \2-ILLEGAL
        illegal
        endc
        rts
        endm

        span    span_well,WELL
        span    span_trashes_d2,TRASHES_D2
        span    span_writes_past,WRITES_PAST
        span    span_writes_before,WRITES_BEFORE
        span    span_skips_last,SKIPS_LAST
        span    span_texel_beside,TEXEL_BESIDE
        span    span_leaves_stack,LEAVES_STACK
        span    span_changes_map,CHANGES_MAP
        span    span_changes_lines,CHANGES_LINES
        span    span_changes_guard,CHANGES_GUARD
        span    span_hangs,HANGS
        span    span_illegal,ILLEGAL
