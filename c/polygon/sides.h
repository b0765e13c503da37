/* The two sides of a convex polygon, from its top vertex down to its bottom one. */
#ifndef SIDES_H
#define SIDES_H

#include "math/math.h"
#include "polygon/polygon.h"

struct sides {
    const struct vertex *first, *last;  /* in the order of the vertices */
    const struct vertex *top, *bottom;  /* the leftmost if there are several */
    const struct vertex *middle;          /* the one farthest from the line between them */
    struct number64 area;               /* twice the area of these three, square pixels: 32.32,
                                           below 2^63 */
    int32 left_step;                    /* bytes to the left side's next vertex; after
                                           the last comes the first */
    fix16 x_low, x_high;
    uint8 middle_right;                   /* side of the middle: 255 right, 0 left */
    uint8 spare[3];
};

/* The smallest integer not below x. */
#define FIX_CEIL(x) (((x) + 0xffff) >> 16)

/* src68k/polygon: contract there. */
enum polygon_result sides_find(struct sides *sides, const struct vertex *vertices, int32 count);

#endif
