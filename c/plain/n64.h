/* Routines of the N64's texture engine in C, called like passes. */
#ifndef PLAIN_N64_H
#define PLAIN_N64_H

#include "n64/passes.h"
#include "plain/call.h"

/* n64_divide_table_make. */
void n64_reciprocals_c(const struct pass_call *call);

/* n64_matrix_make; in: the numbers. */
void n64_matrix_c(const struct pass_call *call);

/* n64_levels_make; constants: the modes. */
void n64_levels_c(const struct pass_call *call);

#endif
