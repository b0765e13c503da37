/* Lines whose texels are in one row of a map, some of them transparent. */
#ifndef KEYED_H
#define KEYED_H

#include "polygon/setup.h"

/* Leaves out the ends of lines whose texels are transparent. */
void keyed_lines(struct setup *s);

#endif
