; The head of a block that mem_alloc and mem_take get from exec.

BLOCK_SIZE              equ     4       ; behind the address of the block before
BLOCK_HEAD              equ     8
