/* Lines of output: collected, then printed in one piece. */
#ifndef TEXT_H
#define TEXT_H

#include "compiler.h"

/* Each adds to the line; what does not fit is cut. */
void text_add(const char *text);
void text_number(int32 value);

/* Prints the line and a line feed, and starts a new one. */
void text_print(void);

/* Moves the line to memory instead, ended by 0, and starts a new one; returns its length. */
int32 text_take(char *to);

/* Prints "name: why" after what was added; returns 0, so that callers can return it. */
int32 text_refuse(const char *name, const char *why);

int32 text_same(const char *a, const char *b);

#endif
