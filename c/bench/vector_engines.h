/* The operations of vector_file.h, engine by engine. */
#ifndef VECTOR_ENGINES_H
#define VECTOR_ENGINES_H

#include "compiler.h"

/* Engines as new, in VECTOR_DRAM_BYTES of memory that each overwrites when it is reset. */
void vector_n64_open(uint8 *memory);
void vector_glide_open(uint8 *memory);

/* Does one operation (enum vector_code), whose longs are as many as it wants. */
void vector_n64_run(uint32 code, const int32 *values, uint32 count);
void vector_glide_run(uint32 code, const int32 *values, uint32 count);

#endif
