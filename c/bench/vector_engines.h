/* The operations of vector_file.h, engine by engine. */
#ifndef VECTOR_ENGINES_H
#define VECTOR_ENGINES_H

#include "compiler.h"

/* Memory, and engines as new; 0 if there is too little. */
int32 vector_tx_open(void);
int32 vector_tmu_open(void);

/* Does one operation (enum vector_code), whose longs are as many as it wants. */
void vector_tx_run(uint32 code, const int32 *values, uint32 count);
void vector_tmu_run(uint32 code, const int32 *values, uint32 count);

#endif
