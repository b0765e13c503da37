/* The calls of tx/calls.h by number. */
#ifndef VECTOR_TX_CALLS_H
#define VECTOR_TX_CALLS_H

#include "tx/calls.h"

/* Makes the call (enum vector_call); arguments that are missing count as 0. Where a call takes
   a struct tx_texture its fields come one by one, those of s and t as wrap, mask, shift; where
   it takes a struct tx_combine, its bytes in order. */
enum tx_result vector_tx_call(struct tx_list *list, uint32 number, const int32 *values,
                              uint32 count);

#endif
