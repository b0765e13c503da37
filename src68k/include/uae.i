; UAE, the emulator, answers at this address to calls with a function's number on the stack, then its arguments.

UAE_TRAP                equ     $f0ff60         ; reads zero where there is no UAE
UAE_EXIT                equ     13
UAE_OPTIONS             equ     82              ; -1, a text of names and values, its bytes, room for an answer, its bytes
