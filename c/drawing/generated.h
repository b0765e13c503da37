/* MAPPER_GENERATED: decides which polygons generated code can draw. Affine spans draw the others
   from the same map: MAP_MARGINS has its page in the same place as MAP_PAGE. */
#ifndef GENERATED_H
#define GENERATED_H

#include "polygon/setup.h"

/* Returns 1 if generated code is worth trying, judged by the vertices. A polygon whose u leaves a
   row of the map mostly has lines that do; rejecting it early is cheapest. */
int32 generated_may_draw(const struct setup *s);

/* Changes s->kind from SPAN_GENERATED to an affine kind if u of a line leaves its row of the map;
   lowers that kind and converts the lines to its form. Call it after the lines are made. */
void generated_span(struct setup *s);

#endif
