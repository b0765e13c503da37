/* How polygons that are drawn front to back leave out what nearer ones hide: called by the drawing of a
   polygon if renderer->cover is set. c/coverage has the routines; programs that do not use it do not link it. */
#ifndef COVER_H
#define COVER_H

#include "polygon/polygon.h"
#include "span/far.h"
#include "span/scanline.h"

struct setup;

struct cover {
    /* Draws a polygon whose outline is found by `rest`, the remaining set-up. */
    enum polygon_result (*draw)(struct setup *s, enum polygon_result (*rest)(struct setup *s));
    /* Draws the table of s->span by the kind of span of s. */
    void (*span)(struct setup *s);
    /* The same by a routine for lines with their own steps. */
    void (*level)(const struct setup *s, struct span_plan *plan, int32 chained,
                  void (*routine)(const struct span_plan *));
    /* Leaves hidden lines of a table that is just made without pixels. */
    void (*lines)(const struct setup *s);
    /* Places lines that are drawn from their far ends. cuts: they may end early. */
    void (*far)(const struct setup *s, struct far_line *lines, int32 leftwards, int32 cuts);
};

#endif
