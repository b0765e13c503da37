        include "routine.i"

; Takes the gap a2, to which a3 points, out of its line's list. The line's first gap is at -4(a1).
drop    macro
        move.l  gap_next(a2),(a3)
        move.l  coverage_unused(a4),gap_next(a2)
        move.l  a2,coverage_unused(a4)
        addq.l  #1,coverage_left(a4)
        cmp.l   -4(a1),d4
        bne.s   .open\@
        subq.l  #1,coverage_open(a4)
.open\@
        endm

; coverage_scan - finds the visible parts of a polygon's lines and covers them
;
; in:      a0  scan_plan*  the table, the gaps of its lines, the coverage
; reads:   the plan, left and last of the table's lines, the gaps
; writes:  of the coverage the gaps, unused, fresh, left, open, seen, overflow, parts and parts_end: a part for each
;          visible part of a line that is not visible whole, and one with last below left for a line that is
;          hidden whole. If there may be too few gaps, overflow is 1 and nothing is covered
; formats: x with EDGE_BIAS, 1 to 32,766
; cost:    90 to 130 cycles a line that is visible or hidden whole
        routine coverage_scan,a0
        save_all
        movea.l scan_plan_coverage(a0),a4
        movea.l coverage_parts(a4),a5
        move.l  scan_plan_count(a0),d7
        lea     coverage_end(a4),a6
        move.l  a6,d4
        moveq   #0,d5                   ; 1 if a pixel is visible
        moveq   #0,d6                   ; the line
        cmp.l   coverage_left(a4),d7    ; each may split a gap
        bgt     .overflow
        movea.l scan_plan_rows(a0),a1
        movea.l scan_plan_lines(a0),a0
        addq.l  #scanline_left,a0
        bra.s   .line

        ; a0 left:last  a1 the next line's gaps  a2 gap  a3 where it is linked  a4 coverage  a5 part
        ; d0 left  d1 last  d2 the gap's left  d3 its last  d4 the gap behind all
.on     lea     gap_next(a2),a3
        movea.l (a3),a2
.find   move.l  (a2),d2                 ; left:last
        cmp.w   d2,d0
        bgt.s   .on
        move.w  d2,d3
        swap    d2
        cmp.w   d2,d0
        blt.s   .begins
        cmp.w   d3,d1
        bgt     .parts
        beq.s   .to_end
        moveq   #1,d5
        cmp.w   d2,d0
        bne.s   .split
        addq.w  #1,d1
        move.w  d1,(a2)
.next   lea     scanline_sizeof(a0),a0
        addq.w  #1,d6
        cmp.w   d7,d6
        beq     .done
.line   move.l  (a0),d1
        movea.l a1,a3
        movea.l (a1)+,a2
        move.l  d1,d0
        swap    d0
        cmp.w   d0,d1
        bge.s   .find
        bra.s   .next

.to_end moveq   #1,d5
        cmp.w   d2,d0
        beq.s   .all
        subq.w  #1,d0
        move.w  d0,gap_last(a2)
        bra.s   .next

.all    drop
        bra.s   .next

.begins cmp.w   d2,d1
        bge.s   .parts
        move.w  d6,(a5)+
        move.l  #1<<16,(a5)+
        bra.s   .next

.split  subq.l  #1,coverage_left(a4)
        move.l  coverage_unused(a4),d2
        beq.s   .fresh
        movea.l d2,a6
        move.l  gap_next(a6),coverage_unused(a4)
.taken  addq.w  #1,d1
        move.w  d1,(a6)
        move.w  d3,gap_last(a6)
        move.l  gap_next(a2),gap_next(a6)
        move.l  a6,gap_next(a2)
        subq.w  #1,d0
        move.w  d0,gap_last(a2)
        bra     .next

.fresh  movea.l coverage_fresh(a4),a6
        addq.l  #gap_sizeof,coverage_fresh(a4)
        bra.s   .taken

.parts  moveq   #1,d5
.part   move.w  d6,(a5)+
        move.w  (a2),d2
        move.w  gap_last(a2),d3
        cmp.w   d0,d2
        bge.s   .left
        move.w  d0,(a5)+                ; the gap begins before the line
        move.w  d3,(a5)+
        move.w  d0,d2
        subq.w  #1,d2
        move.w  d2,gap_last(a2)
        lea     gap_next(a2),a3
        bra.s   .more

.left   move.w  d2,(a5)+
        cmp.w   d1,d3
        bgt.s   .last
        move.w  d3,(a5)+
        drop
.more   movea.l (a3),a2
        cmp.w   (a2),d1
        bge.s   .part
        bra     .next

.last   move.w  d1,(a5)+                ; the gap ends behind it
        addq.w  #1,d1
        move.w  d1,(a2)
        bra     .next

.overflow
        moveq   #1,d0
        move.l  d0,coverage_overflow(a4)
.done   move.l  d5,coverage_seen(a4)
        move.l  a5,coverage_parts_end(a4)
        return_all
