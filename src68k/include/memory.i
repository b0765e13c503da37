; The head of a block that mem_alloc and mem_take get from exec.

        include "amiga.i"

BLOCK_SIZE              equ     4       ; after the address of the previous block
BLOCK_HEAD              equ     8
