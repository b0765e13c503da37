; A plain span routine, span_well, and wrong variants of it: each breaks the contract
; of span_affine_swap in one way. For the tests of
; the checker.

        include "routine.i"

; \1: name, which says what is wrong
variant macro
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
        ifc     \1,span_writes_before
        not.b   -1(a3)
        endc
        ifc     \1,span_texel_beside
        add.l   #$10000,d2
        endc
        ifc     \1,span_skips_last
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
        ifc     \1,span_writes_past
        not.b   (a3)
        endc
.next   ifc     \1,span_changes_lines
        addq.l  #1,scanline_start2(a1)
        endc
        lea     scanline_sizeof(a1),a1
        adda.l  span_plan_pitch(a0),a6
        subq.l  #1,d7
        bne     .line
        ifc     \1,span_changes_map
        not.b   1234(a2)
        endc
        ifc     \1,span_changes_guard
        not.b   span_plan_sizeof+7(a0)
        endc
        ifc     \1,span_hangs
.hang   bra.s   .hang
        endc
        movem.l (sp)+,d2-d7/a2-a6
        ifc     \1,span_trashes_d2
        moveq   #2,d2
        endc
        ifc     \1,span_leaves_stack
        move.l  (sp)+,(sp)              ; returns from one longword higher
        endc
        ifc     \1,span_illegal
        illegal
        endc
        rts
        endm

        variant span_well
        variant span_trashes_d2
        variant span_writes_past
        variant span_writes_before
        variant span_skips_last
        variant span_texel_beside
        variant span_leaves_stack
        variant span_changes_map
        variant span_changes_lines
        variant span_changes_guard
        variant span_hangs
        variant span_illegal
