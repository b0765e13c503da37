        include "amiga.i"

        xref    holes,program_start

; unpack - entry of a scene's program: moves its code to its places, then starts it
;
; reads:   holes, which tools/tmap/product/program_layout.py writes
; writes:  all code but its own
; formats: two addresses: the ends of the code as loaded, and of its places; then words, from the last island of code
;          on: its words less 1, and the bytes of the hole before it

; The program's file has no holes, which code has that keeps its lines of the cache.
        section .text.unpack,code
        xdef    unpack
unpack: lea     holes,a2
        movem.l (a2)+,a0-a1
.island move.w  (a2)+,d0
.word   move.w  -(a0),-(a1)
        dbra    d0,.word
        moveq   #0,d0
        move.w  (a2)+,d0
        suba.l  d0,a1
        cmpa.l  a0,a1
        bne.s   .island
        movea.l sys_base,a6
        cmpi.w  #37,lib_Version(a6)
        blo.s   .start
        lvo     CacheClearU
.start  jmp     program_start
