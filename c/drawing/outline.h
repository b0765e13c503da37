/* What a polygon covers: its sides, the box around it, its edges and table of lines. Every
   polygon passes here once: as functions of their own they would cost it some 200 cycles, 360
   with chip RAM alone. */
#ifndef OUTLINE_H
#define OUTLINE_H

#include "drawing/lower.h"
#include "limits.h"
#include "polygon/clip.h"
#include "polygon/planes.h"

/* Cuts the outline a pixel outside the frame: no pixel centre is lost by rounding. */
enum polygon_result outline_clip(struct setup *s);

static inline int32 outline_least(int32 a, int32 b)
{
    return a < b ? a : b;
}

static inline int32 outline_most(int32 a, int32 b)
{
    return a > b ? a : b;
}

/* 0: nothing of it lies in the frame. */
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
   are not cut: a vertex on the border is rounded, and they would be exact no more. */
static inline enum polygon_result outline_find(struct setup *s)
{
    const int32 exact = s->material->edges == EDGES_EXACT;
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

/* Makes the table by a stepper of edges, and cuts it to the frame's columns. */
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

/* Makes both for a polygon whose planes planes.h finds: a table without coordinates. */
static inline enum polygon_result outline_flat(struct setup *s)
{
    enum polygon_result result;

    s->vertices = planes_vertices(s->scratch, s->given, s->count);
    result = outline_find(s);
    if (result != POLYGON_DRAWN)
        return result;
    outline_lines(s, s->material->edges == EDGES_EXACT ? edge_flat_exact : edge_flat,
                  scissor_flat);
    return POLYGON_DRAWN;
}

#endif
