/* What texture units interpolate over a polygon: planes over the screen, found a pair at a time. */
#ifndef PLANES_H
#define PLANES_H

#include "polygon/setup.h"

enum { PLANES_MAX = 8 };

/* Modulo 2^32: the value at pixel (i, j) of the planes, a pixel's and a line's step. */
struct plane {
    uint32 at, dx, dy;
};

/* Who finds them says which number is what. */
struct planes {
    int32 i, j;
    struct plane of[PLANES_MAX];
};

/* What the corners' coordinates become. */
struct planes_scale {
    int32 bits;                 /* S of an s that is not divided: s times 2^bits */
    int32 one;                  /* W of 1.0, the corner that is nearest; even, above 0 */
    fix16 reach;                /* s and t of two corners are less than this apart */
};

/* Copies x and y of a polygon's vertices to the scratch memory's corners, up to
   POLYGON_VERTICES_MAX, and returns those. planes_pair reads s and t that the caller sets there. */
struct vertex *planes_vertices(struct scratch *scratch, const struct vertex *vertices,
                               int32 count);

/* Planes `first` and `first` + 1 of what the corners' s and t are, times 2^bits; the corners' sides
   and box are found. Two corners are less than 2^31 apart. */
void planes_pair(struct planes *planes, const struct setup *s, int32 first, int32 bits);

/* Planes `first` to `first` + 2: S, T and W of the corners, of which s, t and w (any unit; not 0)
   count; the next one is trashed.

   Where w is the same everywhere, and above 0, or perspective is 0: s and t are planes in 16.16,
   taken times 2^bits; W is `one`. Otherwise W of a corner is `one` |w|least / w, half of that if
   the w of any is below 0, and S is s times 2^bits, times that / `one`, each rounded to the
   nearest; their planes are found from those numbers, S and T raised so that S / W and T / W are
   nowhere below the exact ones where W is above 0.

   0: coordinates of two corners are too far apart. */
int32 planes_coordinates(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *corners, const struct planes_scale *scale,
                         int32 perspective);

/* Of a plane at pixel (x, y). */
uint32 planes_at(const struct planes *planes, int32 which, int32 x, int32 y);

#endif
