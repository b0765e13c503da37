/* Perspective: the planes of 1/w, u/w and v/w over a polygon. */
#ifndef PERSPECTIVE_H
#define PERSPECTIVE_H

#include "polygon/setup.h"
#include "span/reciprocal.h"

/* A corner's values; of the two that planes_find takes as vectors: differences. */
struct plane_corner {
    fix16 x, y;
    int32 q, s, t;              /* up to 2^30, as vectors below 2^31 */
};

/* What planes_find takes. */
struct plane_corners {
    struct plane_corner first, a, b;    /* a, b: vectors from the first, a x b > 0 */
    struct number64 area;               /* a x b, 32.32 */
    fix16 x, y;                         /* from the first corner to the pixel asked for */
};

/* What it gives: values at the pixel, and what they grow by a pixel and a line; 48.16. */
struct found_planes {
    struct screen_plane q, s, t;
};

/* src68k/polygon: contract there. */
void planes_find(struct found_planes *planes, const struct plane_corners *corners);

/* Fills in the planes and bases of a plan, for the box's pixels; 0: the polygon is to be
   drawn affine, because the planes are not sure enough: q of a vertex is below 4 times its
   error. w is not constant; the vertices are as material_vertices gives them. */
int32 perspective_planes(struct perspective_plan *plan, const struct vertex *vertices,
                         int32 count, const struct sides *sides, const struct rectangle *box);

/* The same from the planes of u and v themselves, w being constant: q is 1 everywhere, and
   what is drawn the affine picture. 0: the planes are too steep or wide for that. */
int32 perspective_of_texturing(struct perspective_plan *plan, const struct texturing *t,
                               const struct rectangle *box);

/* The upper half of a gradient's magnitude; the farthest of u and v from their bases. */
int32 perspective_steepness(const struct number64 *gradient);
fix16 perspective_reach(const struct perspective_plan *plan);

/* Whether depth changes so little along lines, at most so many pixels wide, that drawn as if
   it did not they are off by so much, in 1/65536 texel (0 to TOLERANCE_MAX). */
int32 perspective_is_level(const struct perspective_plan *plan, int32 width, int32 tolerance);

/* Draws the lines of the plan, as s->setting and s->straight say. */
void perspective_draw(struct setup *s);

#endif
