; Texture coordinates by add and swap, v held 8 bits higher than u.

; d4 = uuVU of u (d0 = -Uuu) and v (d1 = Vvv-). \1: a register with $00ffffff. 10 bytes.
join_uv macro
        move.l  d1,d4
        eor.l   d0,d4
        and.l   \1,d4
        eor.l   d1,d4                   ; VUuu
        swap    d4
        endm
