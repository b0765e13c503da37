/* The operations of vector_file.h, engine by engine. */
#ifndef VECTOR_ENGINES_H
#define VECTOR_ENGINES_H

#include "compiler.h"

/* Make a new engine in VECTOR_DRAM_BYTES of memory, which each engine overwrites when reset. */
void vector_n64_open(uint8 *memory);
void vector_glide_open(uint8 *memory);

/* Do one operation (enum vector_code); the number of longs must be the operation's. */
void vector_n64_run(uint32 code, const int32 *values, uint32 count);
void vector_glide_run(uint32 code, const int32 *values, uint32 count);

#endif
