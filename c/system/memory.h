/* Memory that drawing routines take while a program runs. A program of its own that draws with texture units, or
   with tables made at run time, has this function; src68k/amiga has ours. */
#ifndef MEMORY_H
#define MEMORY_H

#include "compiler.h"

enum memory_type { MEMORY_ANY = 0, MEMORY_CHIP = 2, MEMORY_FAST = 4 };

/* Stores the address of `bytes` bytes, at a multiple of 8, where `address` points. Returns 1, or 0 where memory is short.
   They are given back at the program's end. */
int32 mem_take(void *address, int32 bytes, int32 kind);

#endif
