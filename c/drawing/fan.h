/* Polygons of more than three vertices whose values lie on no plane. */
#ifndef FAN_H
#define FAN_H

#include "polygon/polygon.h"

/* Those kinds of values, of those asked for, that lie on planes. Of `places` x and y count, of
   `values` the rest. All that are asked for where nothing can be said: the polygon has no area, or
   a coordinate is not in -POLYGON_FAR to POLYGON_FAR. */
uint32 polygon_planar(const struct vertex *places, const struct vertex *values, int32 count,
                      uint32 asked);

/* Whether all that are asked for do, or the caller vouches for them. */
static inline int32 planar_is(const struct drawing *drawing, const struct vertex *places,
                              const struct vertex *values, int32 count, uint32 asked)
{
    asked &= ~drawing->planar;
    return !asked || polygon_planar(places, values, count, asked) == asked;
}

/* The same drawing where the caller vouches for these values and no others: made in *room if it has
   to be. */
static inline const struct drawing *planar_vouched(struct drawing *room,
                                                   const struct drawing *drawing, uint32 values)
{
    if (drawing->planar == values)
        return drawing;
    room->form = drawing->form;
    room->off = drawing->off;
    room->counts = drawing->counts;
    room->planar = values;
    return room;
}

/* What is drawn of a fan of triangles: the first result that refuses one; else POLYGON_DRAWN if
   any is drawn. */
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

/* Draws the polygon as that fan. */
enum polygon_result polygon_fan(polygon_routine *draw, const struct frame *frame,
                                const struct vertex *vertices, int32 count,
                                const struct material *material, const struct drawing *drawing);

#endif
