/* Keeps u and v of every pixel in the mapper's range. */
#ifndef CLAMP_H
#define CLAMP_H

#include "polygon/setup.h"

/* MAPPER_GOURAUD, MAPPER_ARBITRARY: moves lines that might leave the range. */
void clamp_lines(struct setup *s);

#endif
