/* Planes of s, t, w and shade, which the texture engine interpolates over a polygon. */
#ifndef N64_PLANES_H
#define N64_PLANES_H

#include "n64/pixel.h"
#include "polygon/planes.h"

enum n64_interpolant { N64_S, N64_T, N64_W, N64_RED, N64_GREEN, N64_BLUE, N64_ALPHA };

#define N64_W_ONE 0x7fff0000    /* the greatest w: 1.0 */

/* Planes in s15.16, indexed by enum n64_interpolant. */
struct n64_planes {
    struct planes all;
    int32 divided;              /* s and t must be divided by w */
    int32 shaded;
};

/* Finds the planes of a polygon whose outline is found, from planes_vertices. s->given has s and t
   in texels, w and shade, 16.16. planes_coordinates converts them; S is s times 32. If
   perspective is 0, W is 0x7fff0000, and division by it changes nothing.

   shades: non-zero to interpolate colours (R G B A of each vertex; null: the vertices' shades as
   grey, A 255).

   Returns 0 if coordinates of two vertices are 1,024 texels or more apart. */
int32 n64_planes_find(struct n64_planes *planes, const struct setup *s, int32 perspective,
                      int32 shades, const uint32 *colours);

/* Finds the iterators and their gradients at pixel (x, y). */
void n64_planes_point(const struct n64_planes *planes, int32 x, int32 y, struct n64_point *point);

/* Returns an interpolant's value at pixel (x, y). */
uint32 n64_plane_at(const struct n64_planes *planes, enum n64_interpolant which, int32 x, int32 y);

#endif
