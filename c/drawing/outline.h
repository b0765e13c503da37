/* The outline of a polygon: its sides, bounding box, edges and scanline table. These functions are
   inline because calls would cost every polygon some 200 cycles, 360 with chip RAM alone. */
#ifndef OUTLINE_H
#define OUTLINE_H

#include "drawing/lower.h"
#include "limits.h"
#include "polygon/clip.h"
#include "polygon/planes.h"

enum { OUTLINE_ALONE = -1 };    /* instead of a chain: no plane is to be found */

static inline int32 outline_least(int32 a, int32 b)
{
    return a < b ? a : b;
}

static inline int32 outline_most(int32 a, int32 b)
{
    return a > b ? a : b;
}

/* The same as outline_find for a material whose outline is clipped: one pixel outside the frame's
   outermost pixel centres, so that rounding loses none. */
enum polygon_result outline_clipped(struct setup *s, int32 chain);

/* Fills in sides, box and edges from frame, material, vertices and count; unless `chain` (enum chain)
   is below 0, the plane too, whose cuts are set. Exact edges are not clipped: a new vertex on the
   border is rounded, so they would no longer be exact. */
static inline enum polygon_result outline_find(struct setup *s, int32 chain)
{
    int32 exact = EDGES_ARE_EXACT(s->material->edges);

    return s->material->clip == CLIP_VERTICES && !exact ? outline_clipped(s, chain)
                                                        : polygon_find(s, exact, chain);
}

/* Makes the scanline table with an edge stepper and cuts it to the frame's columns. */
static inline void outline_lines(struct setup *s, void (*edges)(const struct edge_plan *plan),
                                 void (*scissor)(const struct scissor_plan *plan))
{
    struct scissor_plan plan;

    edges(&s->edges);
    if (lower_to_no_scissor(s))
        return;
    plan.lines = s->edges.lines;
    plan.count = s->box.bottom - s->box.top;
    plan.width = s->frame->width;
    plan.dudx = s->span.dudx;
    plan.dvdx = s->span.dvdx;
    scissor(&plan);
}

/* Leaves the ends of lines whose texels are transparent out of the table, for SPAN_KEYED_ROW, and lowers s->kind. */
void outline_opaque(struct setup *s);

/* Makes the outline and a table without u and v, for a polygon whose planes planes.h finds. */
static inline enum polygon_result outline_flat(struct setup *s)
{
    enum polygon_result result;

    s->vertices = s->given;
    result = outline_find(s, OUTLINE_ALONE);
    if (result != POLYGON_DRAWN)
        return result;
    outline_lines(s, EDGES_ARE_EXACT(s->material->edges) ? edge_flat_exact : edge_flat,
                  scissor_flat);
    return POLYGON_DRAWN;
}

#endif
