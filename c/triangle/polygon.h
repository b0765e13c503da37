/* Polygons with snapped vertices that routines for triangles can draw. */
#ifndef TRIANGLE_POLYGON_H
#define TRIANGLE_POLYGON_H

#include "math/math.h"
#include "polygon/polygon.h"
#include "triangle/triangles.h"

/* A polygon of more corners is cheaper in one piece. */
enum { TRIANGLE_CORNERS_MAX = 4 };

typedef const struct triangle *triangle_drawer(struct triangle_plan *plan);

/* Returns how triangles of a material with EDGES_SNAPPED are drawn: SPAN_TRIANGLES_*, or the span of
   their lines; SPAN_KINDS if they have no routine. */
enum span_kind triangle_kind(const struct frame *frame, const struct material *material);

/* Returns 1 if routines for triangles, which tables are there for, draw a polygon of more than three corners. */
int32 triangle_takes(const struct frame *frame, const struct polygon *polygon, const struct material *material);

/* Returns the kind for batches of a material's triangles; SPAN_KINDS also if pixels are counted. */
static inline enum span_kind triangle_batch_kind(const struct renderer *renderer,
                                                 const struct material *material)
{
    if (material->edges != EDGES_SNAPPED || !renderer->triangles || renderer->counts
        || material->levels || material->mapper == MAPPER_ARBITRARY)    /* each triangle is tested */
        return SPAN_KINDS;
    return triangle_kind(renderer->frame, material);
}

/* Sets what the frame, the material and the kind decide; triangles_spans uses the lines. Returns the
   routine. */
triangle_drawer *triangle_plan_set(struct triangle_plan *plan, enum span_kind kind,
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

/* Returns the map's scale for plans; 0 for 1. */
static inline fix16 triangle_scale(const struct material *material)
{
    return material->map && material->map->scale != 65536 ? material->map->scale : 0;
}

/* Returns the enum vertex_values of a mapper that has routines for triangles. */
static inline int32 triangle_values(int32 mapper)
{
    return mapper == MAPPER_AFFINE || mapper == MAPPER_ARBITRARY ? VALUES_TEXELS
         : mapper == MAPPER_FLAT ? VALUES_NONE
         : mapper == MAPPER_GOURAUD ? VALUES_SHADES
         : mapper == MAPPER_LIT ? VALUES_LEVEL : VALUES_LEVELS;
}

/* Draws the polygon as a fan of triangles; with renderer->only_counts it only says how it would.
   Vertices and steps may allow a cheaper kind, with the same picture. Returns the kind; SPAN_KINDS, and
   draws nothing, if the material has no routine, the polygon too many corners or too many lines, or a
   vertex out of range (enum snapped_limits). */
enum span_kind triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                       const struct material *material);

/* Draws polygons in their order, as many as possible in one batch; those for which triangle_polygon
   returns SPAN_KINDS by `other`. The renderer counts nothing. Returns POLYGON_DRAWN, or why `other`
   refused one. */
enum polygon_result triangle_run(struct renderer *renderer, const struct polygon *polygons,
                                 int32 count, const struct material *material,
                                 polygon_routine *other);

#endif
