/* A plan in memory. It is checked when it is loaded, so that its users need no checks. */
#ifndef PLAN_H
#define PLAN_H

#include "bench/plan_file.h"
#include "compiler.h"

/* Reads a plan; prints a line and returns 0 if it cannot be used. */
int32 plan_load(const char *name, const uint8 **plan);

/* Returns its cases, plan_header.cases of them. */
const struct plan_case *plan_cases(const uint8 *plan);

/* Returns the checksum of so many longwords, as in plan_header.checksum. */
uint32 plan_checksum(const uint32 *from, uint32 longs);

/* Returns the number of pieces of an image of so many bytes. */
uint32 plan_pieces(uint32 bytes);

#endif
