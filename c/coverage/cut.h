/* Polygons whose lines are cut to what is visible, and polygons that are drawn aside. */
#ifndef CUT_H
#define CUT_H

#include "coverage/coverage.h"

/* Everything coverage_cut needs. */
struct parts_plan {
    const struct visible_part *parts, *end;     /* of the last scan */
    struct scanline *lines;
    const struct scanline_step *steps;  /* of each line, or 0: all have these: */
    fix16 du, dv;               /* texels a pixel */
    int32 chained;              /* 1: each wrap of v takes a unit of u */
    int32 form;                 /* enum line_form */
    struct cut_lines *second, *further;
};

/* src68k/coverage: contract there. */
void coverage_cut(struct parts_plan *plan);

/* Cuts the lines of s->span, in the form of a kind of span, to the visible parts of the last scan and draws
   them. */
void cut_span(struct coverage *coverage, struct setup *s);

/* The same for lines that have steps of their own, addx form. chained: each wrap of v takes a unit of u. */
void cut_level(struct coverage *coverage, struct span_plan *span, int32 chained,
               void (*routine)(const struct span_plan *));

#endif
