/* Polygons of more than three vertices whose values are not on a plane. */
#ifndef FAN_H
#define FAN_H

#include "polygon/scratch.h"

/* Returns those of the given enum planar_values that are on planes, and PLANAR_ROUGH if it is among them. x and y
   are read from `places`, all other fields from `values`. Returns all of the given ones if they cannot be tested:
   the polygon has no area, or a coordinate is not in -POLYGON_FAR to POLYGON_FAR. */
uint32 polygon_planar(struct scratch *scratch, const struct vertex *places,
                      const struct vertex *values, int32 count, uint32 asked);

/* Returns non-zero if all needed values are on planes, as stated in polygon->planar or as found.
   values: vertices whose s, t, w and shade are read. */
static inline int32 polygon_is_planar(const struct renderer *renderer,
                                      const struct polygon *polygon,
                                      const struct vertex *values, uint32 needed)
{
    needed &= ~polygon->planar;
    if (!needed)
        return 1;
    needed |= polygon->planar & PLANAR_ROUGH;
    return polygon_planar(renderer->scratch, polygon->vertices, values, polygon->count, needed) == needed;
}

/* Combines the results of a fan's triangles: the first refusal, else POLYGON_DRAWN if any triangle
   was drawn. */
static inline enum polygon_result planar_both(enum polygon_result all, enum polygon_result more)
{
    return all > POLYGON_EMPTY || more == POLYGON_EMPTY ? all : more;
}

/* Copies triangle i, from 2 to count - 1, of the fan from the first vertex. */
static inline void planar_triangle(struct vertex *to, const struct vertex *vertices, int32 i)
{
    to[0] = vertices[0];
    to[1] = vertices[i - 1];
    to[2] = vertices[i];
}

/* Returns 0 if polygon_is_fan would, for less. */
int32 polygon_may_be_fan(const struct renderer *renderer, const struct polygon *polygon,
                           const struct material *material);

/* Returns 1 if a polygon of a mesh is drawn as a fan of triangles, by polygon_fan or by routines for triangles. */
int32 polygon_is_fan(const struct renderer *renderer, const struct polygon *polygon, const struct material *material);

/* Draws the polygon as a fan of triangles, each with `draw`. */
enum polygon_result polygon_fan(polygon_routine *draw, struct renderer *renderer,
                                const struct polygon *polygon, const struct material *material);

#endif
