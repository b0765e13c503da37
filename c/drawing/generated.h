/* MAPPER_GENERATED: which polygons the code written for them can draw. Affine spans draw the others
   from the same map: MAP_MARGINS has its page where MAP_PAGE has it. */
#ifndef GENERATED_H
#define GENERATED_H

#include "polygon/setup.h"

/* Whether it is worth trying, by the vertices: what lies in more than one row of the map mostly has
   lines that do, and costs least where that is known early. */
int32 generated_may_draw(const struct setup *s);

/* Makes s->kind, SPAN_GENERATED, an affine one, lowered by its own rules, and the lines what that
   one reads, where u of a line leaves its row of the map. After the lines are made. */
void generated_span(struct setup *s);

#endif
