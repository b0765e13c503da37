/* MAPPER_GENERATED: where the code that is written for a polygon cannot draw it. */
#ifndef GENERATED_H
#define GENERATED_H

#include "polygon/setup.h"

/* Makes s->kind, SPAN_GENERATED, an affine one, lowered by its own rules, and the lines what that
   one reads, where u of a line leaves the map's row. The map's page is the same to both. After the
   lines are made. */
void generated_span(struct setup *s);

#endif
