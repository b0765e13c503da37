/* The calls of n64/calls.h by number. */
#ifndef VECTOR_N64_CALLS_H
#define VECTOR_N64_CALLS_H

#include "n64/calls.h"

/* Makes the call (enum vector_call); arguments that are missing count as 0. Where a call takes
   a struct n64_texture its fields come one by one, those of s and t as wrap, mask, shift; where
   it takes a struct n64_combine, its bytes in order. */
enum n64_result vector_n64_call(struct n64_list *list, uint32 number, const int32 *values,
                                uint32 count);

#endif
