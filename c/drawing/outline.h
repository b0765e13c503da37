/* The outline of a polygon: its sides, bounding box, edges and scanline table. These functions are
   inline because calls would cost every polygon some 200 cycles, 360 with chip RAM alone. */
#ifndef OUTLINE_H
#define OUTLINE_H

#include "drawing/lower.h"
#include "limits.h"
#include "polygon/clip.h"
#include "polygon/planes.h"

/* Clips the outline one pixel outside the frame's outermost pixel centres, so that rounding loses
   none. Returns POLYGON_EMPTY if nothing is left, else POLYGON_DRAWN. */
enum polygon_result outline_clip(struct setup *s);

static inline int32 outline_least(int32 a, int32 b)
{
    return a < b ? a : b;
}

static inline int32 outline_most(int32 a, int32 b)
{
    return a > b ? a : b;
}

/* Finds the box of lines and columns in the frame that the sides may cover; returns 0 if it is
   empty. */
static inline int32 outline_box(struct rectangle *box, const struct sides *sides,
                                const struct frame *frame)
{
    box->left = outline_most(FIX_CEIL(sides->x_low - EDGE_ERROR), 0);
    box->right = outline_least(FIX_CEIL(sides->x_high + EDGE_ERROR), frame->width);
    box->top = outline_most(FIX_CEIL(sides->top->y), 0);
    box->bottom = outline_least(FIX_CEIL(sides->bottom->y), frame->height);
    return box->left < box->right && box->top < box->bottom;
}

/* Fills in sides, box, outline and edges from frame, material, vertices and count. Exact edges
   are not clipped: a new vertex on the border is rounded, so they would no longer be exact. */
static inline enum polygon_result outline_find(struct setup *s)
{
    const int32 exact = EDGES_ARE_EXACT(s->material->edges);
    enum polygon_result result = sides_find(&s->sides, s->vertices, s->count);

    if (result != POLYGON_DRAWN)
        return result;
    if (!outline_box(&s->box, &s->sides, s->frame))
        return POLYGON_EMPTY;
    s->outline = s->vertices;
    s->outline_count = s->count;
    s->outline_sides = &s->sides;
    if (s->material->clip == CLIP_VERTICES && !exact && outline_clip(s) != POLYGON_DRAWN)
        return POLYGON_EMPTY;
    s->edges.lines = s->scratch->lines;
    s->edges.left = s->scratch->left;
    s->edges.right = s->scratch->right;
    edges_make(&s->edges, s->outline_sides, &s->box, exact);
    return POLYGON_DRAWN;
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

/* Makes the outline and a table without u and v, for a polygon whose planes planes.h finds. */
static inline enum polygon_result outline_flat(struct setup *s)
{
    enum polygon_result result;

    s->vertices = planes_vertices(s->scratch, s->given, s->count);
    result = outline_find(s);
    if (result != POLYGON_DRAWN)
        return result;
    outline_lines(s, EDGES_ARE_EXACT(s->material->edges) ? edge_flat_exact : edge_flat,
                  scissor_flat);
    return POLYGON_DRAWN;
}

#endif
