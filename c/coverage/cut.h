/* Polygons whose lines are cut to what is visible, and polygons that are drawn aside. */
#ifndef CUT_H
#define CUT_H

#include "coverage/coverage.h"

/* Cuts the lines of s->span, in the form of a kind of span, to the visible parts of the last scan and draws
   them. */
void cut_span(struct coverage *coverage, struct setup *s);

/* The same for lines that have steps of their own, addx form. chained: each wrap of v takes a unit of u. */
void cut_level(struct coverage *coverage, struct span_plan *plan, int32 chained,
               void (*routine)(const struct span_plan *));

#endif
