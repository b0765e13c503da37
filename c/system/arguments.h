/* Numbers of a command line. */
#ifndef ARGUMENTS_H
#define ARGUMENTS_H

#include "compiler.h"

/* The number that args_read found for a /K/N, from least to end (excluded), or *value as it is where
   there is none. Else prints "program: why" and returns 0. */
int32 number_asked(const char *program, int32 argument, int32 least, int32 end, int32 *value,
                   const char *why);

#endif
