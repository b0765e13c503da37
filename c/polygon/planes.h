/* Planes over the screen that texture units interpolate, found a pair at a time. */
#ifndef PLANES_H
#define PLANES_H

#include "polygon/setup.h"

enum { PLANES_MAX = 8, PLANES_CORNERS = 3 };

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
    fix16 reach;                /* s and t of two vertices are less than this apart; a power of two */
};

/* How corners' coordinates are multiplied by W. */
struct planes_division {
    uint32 least;               /* |w| of the nearest corner */
    int32 nearest;              /* its W: `one`, or half of it */
    int32 one, bits;            /* of struct planes_scale */
};

/* src68k/polygon: contract there. */
void corners_divide(struct vertex *corners, const struct planes_division *division);

/* The corners that planes go through: the top, the bottom and the middle one of a polygon's sides, with
   values of their own as s and t. */
struct planes_corners {
    struct vertex of[PLANES_CORNERS];
    struct sides sides;         /* as far as texturing_plane reads it */
};

/* Sets x and y of the corners of a polygon whose outline is found; the caller sets their s and t. */
void planes_open(struct planes_corners *corners, const struct setup *s);

/* Finds planes `first` and `first` + 1 from the corners' s and t. The s of two corners are less than
   2^31 apart, and so are the t. */
void planes_pair(struct planes *planes, const struct setup *s, const struct planes_corners *corners,
                 int32 first);

/* Returns corner n of a polygon among vertices that correspond to those given. */
static inline const struct vertex *planes_corner(const struct setup *s, const struct vertex *vertices,
                                                 int32 n)
{
    const struct sides *sides = &s->sides;
    const struct vertex *corner = !n ? sides->top : n == 1 ? sides->bottom : sides->middle;

    return (const struct vertex *)((const uint8 *)vertices + ((const uint8 *)corner - (const uint8 *)s->given));
}

/* Finds planes `first` to `first` + 2: S, T and W, from the vertices' s, t and w (any unit; not 0).
   Overwrites the next plane. Returns 0 if the coordinates of two vertices are too far apart.

   If w is constant and above 0, or perspective is 0: s and t are planes in 16.16, times 2^bits; W
   is `one`. Otherwise W of a corner is `one` |w|least / w, half of that if the w of any is below 0,
   and S is s times 2^bits, times W / `one`, each rounded to the nearest. Their planes are found
   from those numbers; S and T are raised so that S / W and T / W are nowhere below the exact ones
   where W is above 0. */
int32 planes_coordinates(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *vertices, const struct planes_scale *scale,
                         int32 perspective);

/* Returns a plane's value at pixel (x, y). */
uint32 planes_at(const struct planes *planes, int32 which, int32 x, int32 y);

#endif
