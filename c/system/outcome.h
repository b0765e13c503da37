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

/* Creates a file that is written in pieces; prints a line and returns 0 if it cannot. However the
   program ends, the file is deleted if outcome_keep has not been called; one at a time. `name` stays
   where it is. */
int32 outcome_create(const char *name);

/* That file is whole: closes it. */
void outcome_keep(void);

/* The program's return code. Not `done`: what a break or a lack calls for, else RETURN_ERROR. */
int32 outcome_code(int32 done);

#endif
