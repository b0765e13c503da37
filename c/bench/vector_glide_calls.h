/* The calls of glide/glide.h by number. */
#ifndef VECTOR_GLIDE_CALLS_H
#define VECTOR_GLIDE_CALLS_H

#include "glide/pixel.h"

/* Makes the call (enum vector_glide_call); arguments that are missing count as 0. texels: room
   for those of a call; own: its own answer. */
enum glide_result vector_glide_call(struct glide *glide, uint32 number, const int32 *values,
                                    uint32 count, uint8 *texels, uint32 *own);

/* What stands for many numbers: each times twice its place plus one, added. */
uint32 vector_sum(uint32 sum, uint32 place, uint32 value);

#endif
