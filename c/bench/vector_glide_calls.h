/* The calls of glide/glide.h by number. */
#ifndef VECTOR_GLIDE_CALLS_H
#define VECTOR_GLIDE_CALLS_H

#include "glide/pixel.h"

/* Makes the call (enum vector_glide_call); missing arguments are 0. texels: room for the texels of
   a call; *own becomes the call's answer. */
enum glide_result vector_glide_call(struct glide *glide, uint32 number, const int32 *values,
                                    uint32 count, uint8 *texels, uint32 *own);

/* A checksum of many numbers: returns sum + value * (2 * place + 1). */
uint32 vector_sum(uint32 sum, uint32 place, uint32 value);

#endif
