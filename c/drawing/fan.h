/* Polygons of more than three vertices whose values lie on no plane. */
#ifndef FAN_H
#define FAN_H

#include "polygon/scratch.h"

/* Those kinds of values, of those asked for, that lie on planes. Of `places` x and y count, of
   `values` the rest. All that are asked for where nothing can be said: the polygon has no area, or
   a coordinate is not in -POLYGON_FAR to POLYGON_FAR. */
uint32 polygon_planar(struct scratch *scratch, const struct vertex *places,
                      const struct vertex *values, int32 count, uint32 asked);

/* Returns non-zero if all needed values lie on planes, by the caller's word or as found. values:
   vertices whose s, t, w and shade count. */
static inline int32 polygon_is_planar(const struct renderer *renderer,
                                      const struct polygon *polygon,
                                      const struct vertex *values, uint32 needed)
{
    needed &= ~polygon->planar;
    return !needed
        || polygon_planar(renderer->scratch, polygon->vertices, values, polygon->count, needed)
           == needed;
}

/* The result of a fan of triangles: the first that refuses one; else POLYGON_DRAWN if any is
   drawn. */
static inline enum polygon_result planar_both(enum polygon_result all, enum polygon_result more)
{
    return all > POLYGON_EMPTY || more == POLYGON_EMPTY ? all : more;
}

/* Triangle i, from 2 to count - 1, of the fan from the first vertex. */
static inline void planar_triangle(struct vertex *to, const struct vertex *vertices, int32 i)
{
    to[0] = vertices[0];
    to[1] = vertices[i - 1];
    to[2] = vertices[i];
}

/* Draws the polygon as that fan, by a routine for each triangle. */
enum polygon_result polygon_fan(polygon_routine *draw, struct renderer *renderer,
                                const struct polygon *polygon, const struct material *material);

#endif
