/* Lines of output: collected, then printed in one piece. */
#ifndef TEXT_H
#define TEXT_H

#include "compiler.h"

/* Add to the line; text that does not fit is cut off. */
void text_add(const char *text);
void text_number(int32 value);

/* Prints the line and a line feed, and starts a new line. */
void text_print(void);

/* Moves the line to memory instead, ended by 0, and starts a new line; returns its length. */
int32 text_take(char *to);

/* Adds "name: why" to the line and prints it; returns 0, so that callers can return it. */
int32 text_refuse(const char *name, const char *why);

int32 text_same(const char *a, const char *b);

#endif
