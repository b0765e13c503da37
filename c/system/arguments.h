/* Numbers on a command line. */
#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#include "compiler.h"

/* Sets *value to the number that args_read found for a /K/N item; without a number *value keeps its
   default. Prints "program: why" and returns 0 if the number is not in least to end (excluded). */
int32 number_asked(const char *program, int32 argument, int32 least, int32 end, int32 *value,
                   const char *why);

#endif
