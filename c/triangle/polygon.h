/* Polygons with snapped vertices that routines for triangles can draw. */
#ifndef TRIANGLE_POLYGON_H
#define TRIANGLE_POLYGON_H

#include "math/math.h"
#include "polygon/polygon.h"
#include "triangle/triangles.h"

/* A polygon of more corners is cheaper in one piece. */
enum { TRIANGLE_CORNERS_MAX = 4 };

typedef const struct triangle *triangle_drawer(struct triangle_plan *plan);

/* Returns the routine for a material with EDGES_SNAPPED and the frame's pixels, or 0. */
triangle_drawer *triangle_routine(const struct frame *frame, const struct material *material);

/* Returns the routine that draws batches of a material's triangles, or 0: there is none, or pixels
   are counted. */
static inline triangle_drawer *triangle_drawer_of(const struct renderer *renderer,
                                                  const struct material *material)
{
    if (material->edges != EDGES_SNAPPED || !renderer->triangles || renderer->counts)
        return 0;
    return triangle_routine(renderer->frame, material);
}

/* Returns the kind that its pixels are counted as; triangles_spans calls its span. */
enum span_kind triangle_kind(const struct frame *frame, const struct material *material);

/* Sets what the frame and the material decide; triangles_spans, if that is the material's routine, uses
   the lines. */
void triangle_plan_set(struct triangle_plan *plan, triangle_drawer *routine,
                       struct triangle_lines *to, const struct renderer *renderer,
                       const struct material *material);

/* The largest x and y of vertices, 1/16 pixel. */
struct triangle_range {
    uint32 right, bottom;
};

static inline void triangle_range_set(struct triangle_range *range, const struct frame *frame)
{
    const uint32 width = (uint32)frame->width;

    range->right = (width < (uint32)SNAPPED_WIDTH ? width : (uint32)SNAPPED_WIDTH) * SNAPPED_ONE;
    range->bottom = (uint32)frame->height * SNAPPED_ONE;
}

/* Converts vertices; x of those that are out of range becomes -1. Returns non-zero if all are in
   range. */
int32 triangle_vertices(struct snapped_vertex *to, const struct vertex *from, int32 count,
                        const struct frame *frame, const struct material *material);

/* Draws the polygon as a fan of triangles; with renderer->only_counts it only says whether it would.
   Returns 0, and draws nothing, if the material has no routine, the polygon too many corners or too
   many lines, or a vertex out of range (enum snapped_limits). */
int32 triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                       const struct material *material);

#endif
