/* The ways of polygon_draw. */
#ifndef DRAW_H
#define DRAW_H

#include "polygon/polygon.h"

static inline int32 is_polygon(const struct polygon *polygon)
{
    return polygon->count >= 3 && polygon->count <= POLYGON_VERTICES_MAX;
}

/* Returns non-zero if a polygon's first vertex is outside the frame: a quick test of whether all of it
   may be. */
static inline int32 begins_outside(const struct renderer *renderer, const struct polygon *polygon)
{
    const struct frame *const frame = renderer->frame;
    const struct vertex *const first = polygon->vertices;

    return (uint32)first->x >= (uint32)frame->width << 16
        || (uint32)first->y >= (uint32)frame->height << 16;
}

/* Returns the values (enum planar_values) that are drawn as planes through three corners. */
static inline uint32 planes_asked(const struct material *m)
{
    if (m->mapper == MAPPER_FLAT || m->gradients != GRADIENTS_PLANE)
        return 0;
    if (m->mapper == MAPPER_GOURAUD)
        return PLANAR_SHADES;
    return (m->perspective ? PLANAR_DEPTHS : PLANAR_TEXELS)
         | (m->mapper == MAPPER_LIT_GOURAUD ? PLANAR_SHADES : 0);
}

/* Polygons whose first vertex is inside the frame, and outside. */
polygon_routine polygon_draw_inside, polygon_draw_beyond;

/* Polygons by their own outline: without routines for triangles, and without a test of whether all of
   them is outside. */
polygon_routine polygon_draw_whole;

/* Triangles whose first vertex is inside the frame; not with EDGES_SNAPPED. */
polygon_routine polygon_draw_three;

/* Polygons in perspective whose first vertex is inside the frame; not with EDGES_SNAPPED. */
polygon_routine polygon_draw_deep;

/* Counts a polygon that routines for triangles draw: its pixels are those of exact edges. */
void polygon_count_snapped(struct renderer *renderer, const struct polygon *polygon,
                           const struct material *material, enum span_kind kind);

#endif
