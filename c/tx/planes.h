/* What the texture engine interpolates over a polygon: planes of s, t, w and shade. */
#ifndef TX_PLANES_H
#define TX_PLANES_H

#include "polygon/setup.h"
#include "tx/pixel.h"

enum tx_interpolant { TX_S, TX_T, TX_W, TX_RED, TX_GREEN, TX_BLUE, TX_ALPHA, TX_INTERPOLANTS };

#define TX_W_ONE 0x7fff0000     /* the greatest w: 1.0 */

/* s15.16 modulo 2^32: the value at pixel (i, j) of the planes, a pixel's and a line's step. */
struct tx_plane {
    uint32 at, dx, dy;
};

struct tx_planes {
    int32 i, j;
    int32 divided;              /* s and t are to be divided by w */
    int32 shaded;
    struct tx_plane of[TX_INTERPOLANTS];
};

/* Copies x and y of a polygon's vertices to where tx_planes_find looks for them: up to
   POLYGON_VERTICES_MAX. */
const struct vertex *tx_planes_vertices(const struct vertex *vertices, int32 count);

/* Finds the planes of a polygon whose outline is found, from the vertices above: s->given has
   s and t in texels, w and shade, 16.16.

   Where w is the same everywhere, or perspective is 0: s and t are planes in 1/65536 texel,
   taken times 32. w is 0x7fff, by which a divide changes nothing. Otherwise w of a vertex is
   0x7fff0000 w_least / w, and s the coordinate in 1/(32 * 65536) texel times that / 0x7fff0000,
   each rounded to the nearest; their planes are found from those numbers.

   shades: what is interpolated of colours (R G B A of each vertex; 0: vertices' shades as grey,
   A 255), or not.

   0: coordinates of two vertices are 1,024 texels or more apart. */
int32 tx_planes_find(struct tx_planes *planes, const struct setup *s, int32 perspective,
                     int32 shades, const uint32 *colours);

/* Iterators and their gradients at pixel (x, y). */
void tx_planes_point(const struct tx_planes *planes, int32 x, int32 y, struct tx_point *point);

/* Of an interpolant at pixel (x, y). */
uint32 tx_plane_at(const struct tx_planes *planes, enum tx_interpolant which, int32 x, int32 y);

#endif
