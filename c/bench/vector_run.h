/* The operations of vector_file.h. */
#ifndef VECTOR_RUN_H
#define VECTOR_RUN_H

#include "compiler.h"

/* Does one operation (enum vector_code); its longs must be as many as it wants. Where there is
   too little memory for the first one, prints a line and returns 0. */
int32 vectors_run(uint32 code, const int32 *values, uint32 count);

#endif
