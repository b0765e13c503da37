/* Whether an operation of vector_file.h can be run. */
#ifndef VECTOR_CHECK_H
#define VECTOR_CHECK_H

#include "compiler.h"

/* Returns 1 if an operation (enum vector_code) has as many longs as it wants and if no value would
   make it write outside its memory or run without end. */
int32 vector_usable(uint32 code, const int32 *values, uint32 longs);

#endif
