/* Planes over the screen that texture units interpolate, found a pair at a time. */
#ifndef PLANES_H
#define PLANES_H

#include "polygon/setup.h"

enum { PLANES_MAX = 8 };

/* The value at pixel (i, j) of struct planes, and its steps a pixel and a line; modulo 2^32. */
struct plane {
    uint32 at, dx, dy;
};

/* The caller decides which value each plane has. */
struct planes {
    int32 i, j;
    struct plane of[PLANES_MAX];
};

/* How the corners' coordinates are scaled. */
struct planes_scale {
    int32 bits;                 /* S of an undivided s is s times 2^bits */
    int32 one;                  /* W of the nearest corner, 1.0; even, above 0 */
    fix16 reach;                /* s and t of two corners are less than this apart */
};

/* Copies x and y of a polygon's vertices, up to POLYGON_VERTICES_MAX, to the scratch memory's
   corners and returns these. The caller sets their s and t, which planes_pair reads. */
struct vertex *planes_vertices(struct scratch *scratch, const struct vertex *vertices,
                               int32 count);

/* Finds planes `first` and `first` + 1 from the corners' s and t, times 2^bits. The setup has the
   corners' sides and box. The s of two corners are less than 2^31 apart, and so are the t. */
void planes_pair(struct planes *planes, const struct setup *s, int32 first, int32 bits);

/* Finds planes `first` to `first` + 2: S, T and W, from the corners' s, t and w (any unit; not 0).
   Overwrites the next plane. Returns 0 if the coordinates of two corners are too far apart.

   If w is constant and above 0, or perspective is 0: s and t are planes in 16.16, times 2^bits; W
   is `one`. Otherwise W of a corner is `one` |w|least / w, half of that if the w of any is below 0,
   and S is s times 2^bits, times W / `one`, each rounded to the nearest. Their planes are found
   from those numbers; S and T are raised so that S / W and T / W are nowhere below the exact ones
   where W is above 0. */
int32 planes_coordinates(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *corners, const struct planes_scale *scale,
                         int32 perspective);

/* Returns a plane's value at pixel (x, y). */
uint32 planes_at(const struct planes *planes, int32 which, int32 x, int32 y);

#endif
