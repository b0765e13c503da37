/* How a program ends: why it did not do all, and what it returns for that. */
#ifndef OUTCOME_H
#define OUTCOME_H

#include "compiler.h"

/* Asks for Ctrl-C; 1: the program is to end, with RETURN_WARN. A line says so. */
int32 outcome_break(void);

/* The machine lacks something: prints "name: what"; returns 0, so that callers can return it. */
int32 outcome_lack(const char *name, const char *what);

/* mem_alloc has just failed: prints "name: not enough memory for purpose", how much that was, of
   which kind, and what there is in one piece; returns 0. */
int32 outcome_lack_memory(const char *name, const char *purpose);

/* The program's return code. Not `done`: what a break or a lack calls for, else RETURN_ERROR. */
int32 outcome_code(int32 done);

#endif
