/* A plan in memory: loaded and checked, so that nothing else need be. */
#ifndef PLAN_H
#define PLAN_H

#include "bench/plan_file.h"
#include "compiler.h"

/* Reads a plan; prints a line and returns 0 if it cannot be used. */
int32 plan_load(const char *name, const uint8 **plan);

/* Its cases, plan_header.cases of them. */
const struct plan_case *plan_cases(const uint8 *plan);

/* As plan_header.checksum says, of so many longwords. */
uint32 plan_checksum(const uint32 *from, uint32 longs);

/* The number of pieces that an image of so many bytes is cut into. */
uint32 plan_pieces(uint32 bytes);

#endif
