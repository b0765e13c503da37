/* Lines of output: collected, then printed in one piece. */
#ifndef TEXT_H
#define TEXT_H

#include "compiler.h"

/* Each adds to the line; what does not fit is cut. */
void text_add(const char *text);
void text_number(int32 value);

/* Prints the line and a line feed, and starts a new one. */
void text_print(void);

#endif
