/* The operations of vector_file.h. */
#ifndef VECTOR_RUN_H
#define VECTOR_RUN_H

#include "compiler.h"

/* A texture engine that writes its answers into an open file; prints a line and returns 0 if
   there is no memory for it. */
int32 vectors_open(int32 file);

/* Does one operation (enum vector_code); its longs must be as many as it wants. */
void vectors_run(uint32 code, const int32 *values, uint32 count);

/* Writes the answers that are still kept; prints a line and returns 0 if any could not be. */
int32 vectors_flush(void);

#endif
