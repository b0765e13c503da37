/* The operations of vector_file.h. */
#ifndef VECTOR_RUN_H
#define VECTOR_RUN_H

#include "compiler.h"

/* Takes memory for the engines; prints a line and returns 0 where it is short. */
int32 vectors_open(void);

/* Does one operation (enum vector_code); its longs must be as many as it wants. */
void vectors_run(uint32 code, const int32 *values, uint32 count);

#endif
