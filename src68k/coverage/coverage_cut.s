        include "chain.i"

; coverage_cut - makes the lines of a table their first visible parts, and their other parts lines of two lists
;
; in:      a0  parts_plan*  the parts, the table and its steps, the lists
; reads:   the plan, the parts, lines and steps of their rows
; writes:  these lines; the lists behind their counts, and these; du and dv of the plan if lines have steps
; formats: as scissor_addx and scissor_plain; a plan that is chained adds a unit to u for each time that v wraps upwards
;          and takes one where downwards
; error:   none: u, v as at the part's first pixel on the whole line, modulo 256 in the addx form
; cost:    bench row coverage_cut: a line that is cut into two parts

; a0 part  a1 the row's first  a2 list  a3 line  a4 plan  a5 line that is cut  d7 row
        routine coverage_cut,a0
        save_all
        movea.l a0,a4
        movea.l parts_plan_parts(a4),a0
        cmpa.l  parts_plan_end(a4),a0
        beq     .done
.row    movea.l a0,a1
        moveq   #0,d7
        move.w  (a0),d7                 ; visible_part_row
        movea.l parts_plan_lines(a4),a3
        move.l  d7,d0
        add.l   d0,d0
        add.l   d7,d0
        lea     (a3,d0.l*4),a3          ; scanline_sizeof
        movea.l parts_plan_second(a4),a2
        move.l  parts_plan_steps(a4),d0
        beq.s   .next
        movea.l d0,a6
        movem.l (a6,d7.l*8),d0-d1       ; scanline_step_sizeof
        movem.l d0-d1,parts_plan_du(a4)   ; and dv
.next   addq.l  #visible_part_sizeof,a0
        cmpa.l  parts_plan_end(a4),a0
        beq.s   .first
        cmp.w   (a0),d7
        bne.s   .first
        move.l  cut_lines_count(a2),d0
        addq.l  #1,cut_lines_count(a2)
        movea.l cut_lines_rows(a2),a6
        move.w  d7,(a6,d0.l*2)
        tst.l   parts_plan_steps(a4)
        beq.s   .same
        movea.l cut_lines_steps(a2),a6
        lea     (a6,d0.l*8),a6
        move.l  parts_plan_du(a4),(a6)+
        move.l  parts_plan_dv(a4),(a6)
.same   movea.l cut_lines_lines(a2),a5
        move.l  d0,d1
        add.l   d0,d0
        add.l   d1,d0
        lea     (a5,d0.l*4),a5
        move.l  (a3),(a5)
        move.l  4(a3),4(a5)
        move.l  8(a3),8(a5)
        move.l  visible_part_left(a0),d0
        bsr.s   .cut
        movea.l parts_plan_further(a4),a2
        bra.s   .next
.first  move.l  visible_part_left(a1),d0
        movea.l a3,a5
        bsr.s   .cut
        cmpa.l  parts_plan_end(a4),a0
        bne     .row
.done   return_all

; Makes the line a5 the part d0, left:last. Uses d0-d4.
.cut    move.l  d0,d2
        swap    d2
        move.w  d2,d3
        sub.w   scanline_left(a5),d3
        move.l  d0,scanline_left(a5)    ; and last
        tst.w   d3
        ble.s   .cut_done
        cmp.w   d2,d0
        blt.s   .cut_done               ; it is hidden whole
        ext.l   d3
        moveq   #LINES_ADDX,d0
        cmp.l   parts_plan_form(a4),d0
        bne.s   .plain
        moveq   #0,d0
        move.b  scanline_start2+3(a5),d0
        swap    d0
        move.w  scanline_start0(a5),d0  ; -Uuu
        moveq   #0,d4
        move.w  scanline_start1(a5),d4
        lsl.l   #8,d4
        move.b  scanline_start2(a5),d4  ; -Vvv
        move.l  parts_plan_du(a4),d1
        muls.l  d3,d1
        add.l   d1,d0
        move.l  parts_plan_dv(a4),d1
        tst.l   parts_plan_chained(a4)
        beq.s   .alone
        lsl.l   #8,d1
        asr.l   #8,d1
        muls.l  d3,d2:d1
        add.l   d1,d4
        moveq   #0,d1
        addx.l  d1,d2
        move.l  d4,d1
        rol.l   #8,d1
        lsl.l   #8,d2
        move.b  d1,d2                   ; how often v wraps
        add.l   d2,d0
        bra.s   .pack
.alone  muls.l  d3,d1
        add.l   d1,d4
.pack   pack_start d0,d4,d1,a5
.cut_done
        rts
.plain  moveq   #LINES_PLAIN,d0
        cmp.l   parts_plan_form(a4),d0
        bne.s   .cut_done
        move.w  scanline_start1(a5),d0
        swap    d0
        move.w  scanline_start0(a5),d0  ; UUuu
        move.l  parts_plan_du(a4),d1
        muls.l  d3,d1
        add.l   d1,d0
        move.w  d0,scanline_start0(a5)
        swap    d0
        move.w  d0,scanline_start1(a5)
        move.l  parts_plan_dv(a4),d1
        muls.l  d3,d1
        add.l   d1,scanline_start2(a5)
        rts
