/* Polygons whose lines are cut to what is visible, and polygons that are drawn aside. */
#ifndef CUT_H
#define CUT_H

#include "coverage/coverage.h"

/* The routines of this room that the drawing of polygons calls. */
extern const struct cover coverage_routines;

/* Takes memory for lines; returns 0 if it is short. */
int32 cut_lines_make(struct cut_lines *lines, int32 count);

/* Cuts the lines of s->span, in the form of a kind of span, to the visible parts of the last scan and draws
   them. */
void cut_span(struct coverage *coverage, struct setup *s);

/* The same for lines that have steps of their own, addx form. chained: each wrap of v takes a unit of u. */
void cut_level(struct coverage *coverage, struct span_plan *plan, int32 chained,
               void (*routine)(const struct span_plan *));

#endif
