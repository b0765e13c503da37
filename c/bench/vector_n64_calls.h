/* The calls of n64/calls.h by number. */
#ifndef VECTOR_N64_CALLS_H
#define VECTOR_N64_CALLS_H

#include "n64/calls.h"

/* Makes the call (enum vector_call); missing arguments are 0. A struct n64_texture is given field
   by field, with wrap, mask and shift for s and t; a struct n64_combine is given byte by byte. */
enum n64_result vector_n64_call(struct n64_list *list, uint32 number, const int32 *values,
                                uint32 count);

#endif
