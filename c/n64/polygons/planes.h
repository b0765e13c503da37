/* What the texture engine interpolates over a polygon: planes of s, t, w and shade. */
#ifndef N64_PLANES_H
#define N64_PLANES_H

#include "n64/pixel.h"
#include "polygon/planes.h"

enum n64_interpolant { N64_S, N64_T, N64_W, N64_RED, N64_GREEN, N64_BLUE, N64_ALPHA };

#define N64_W_ONE 0x7fff0000    /* the greatest w: 1.0 */

/* s15.16, numbered by enum n64_interpolant. */
struct n64_planes {
    struct planes all;
    int32 divided;              /* s and t are to be divided by w */
    int32 shaded;
};

/* Finds the planes of a polygon whose outline is found, from planes_vertices: s->given has s and t
   in texels, w and shade, 16.16. What they become: planes_coordinates, S being s times 32; W is
   0x7fff0000 where w does not count, by which a divide changes nothing.

   shades: what is interpolated of colours (R G B A of each vertex; 0: vertices' shades as grey,
   A 255), or not.

   0: coordinates of two vertices are 1,024 texels or more apart. */
int32 n64_planes_find(struct n64_planes *planes, const struct setup *s, int32 perspective,
                      int32 shades, const uint32 *colours);

/* Iterators and their gradients at pixel (x, y). */
void n64_planes_point(const struct n64_planes *planes, int32 x, int32 y, struct n64_point *point);

/* Of an interpolant at pixel (x, y). */
uint32 n64_plane_at(const struct n64_planes *planes, enum n64_interpolant which, int32 x, int32 y);

#endif
