/* What the texture engine interpolates over a polygon: planes of s, t, w and shade. */
#ifndef TX_PLANES_H
#define TX_PLANES_H

#include "polygon/planes.h"
#include "tx/pixel.h"

enum tx_interpolant { TX_S, TX_T, TX_W, TX_RED, TX_GREEN, TX_BLUE, TX_ALPHA };

#define TX_W_ONE 0x7fff0000     /* the greatest w: 1.0 */

/* s15.16, numbered by enum tx_interpolant. */
struct tx_planes {
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
int32 tx_planes_find(struct tx_planes *planes, const struct setup *s, int32 perspective,
                     int32 shades, const uint32 *colours);

/* Iterators and their gradients at pixel (x, y). */
void tx_planes_point(const struct tx_planes *planes, int32 x, int32 y, struct tx_point *point);

/* Of an interpolant at pixel (x, y). */
uint32 tx_plane_at(const struct tx_planes *planes, enum tx_interpolant which, int32 x, int32 y);

#endif
