/* The operations of vector_file.h. */
#ifndef VECTOR_RUN_H
#define VECTOR_RUN_H

#include "compiler.h"

/* Does one operation (enum vector_code); the number of longs must be the operation's. The first
   call allocates the engines' memory; prints a line and returns 0 if it is short. */
int32 vectors_run(uint32 code, const int32 *values, uint32 count);

#endif
