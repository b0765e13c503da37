/* Clips convex polygons to a rectangle (Sutherland and Hodgman, 1974). */
#ifndef CLIP_H
#define CLIP_H

#include "polygon/polygon.h"

/* Pixels in 16.16, borders included. */
struct clip_window {
    fix16 left, top, right, bottom;
};

enum clip_constants {
    CLIP_VERTICES_MAX = POLYGON_VERTICES_MAX + 4        /* each border adds one at most */
};

/* Returns the part of a convex polygon inside the window, with s, t and shade; sets *count to its
   number of vertices, 0 if nothing is left. A polygon wholly inside is returned itself, at the cost
   of the test; a clipped one is made in room[2 * CLIP_VERTICES_MAX]. New vertices are rounded to
   the nearest 1/65536. An edge gives the same new vertices in either direction, so polygons that
   share an edge still share it. A polygon that would get too many vertices becomes empty; a convex
   one cannot get so many. */
const struct vertex *polygon_clip(struct vertex *room, const struct vertex *vertices,
                                  int32 *count, const struct clip_window *window);

#endif
