/* How a program ends: messages for incomplete work, and return codes. */
#ifndef OUTCOME_H
#define OUTCOME_H

#include "compiler.h"

/* Checks for Ctrl-C. Returns 1 if it was pressed: the program should end, with RETURN_WARN. A line
   says so. */
int32 outcome_break(void);

/* For something that the machine lacks: prints "name: what"; returns 0, so that callers can return
   it. */
int32 outcome_lack(const char *name, const char *what);

/* For a mem_alloc that has just failed: prints "name: not enough memory for purpose", the size and
   kind of that memory, and the largest free piece; returns 0. */
int32 outcome_lack_memory(const char *name, const char *purpose);

/* Creates a file that is written in pieces; prints a line and returns 0 if it cannot. One at a
   time. Unless outcome_keep is called, the file is deleted when the program ends, even by a crash.
   `name` must stay valid until then. */
int32 outcome_create(const char *name);

/* Closes that file and keeps it: it is complete. */
void outcome_keep(void);

/* Returns the program's return code: RETURN_OK if done, otherwise RETURN_WARN after a break,
   RETURN_FAIL after a lack, else RETURN_ERROR. */
int32 outcome_code(int32 done);

#endif
