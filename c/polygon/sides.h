/* The two sides of a convex polygon, from its top vertex down to its bottom one. */
#ifndef SIDES_H
#define SIDES_H

#include "polygon/polygon.h"

struct sides {
    int32 top, bottom;          /* vertices; of several the leftmost */
    int32 apex;                 /* the vertex farthest from the line between them */
    int32 left_step;            /* +1: the left side follows the vertex order; -1 */
    fix16 x_low, x_high;
};

/* The smallest integer not below x. */
#define FIX_CEIL(x) (((x) + 0xffff) >> 16)

/* The difference a - b of x, y, s and t. */
void vertex_difference(struct vertex *out, const struct vertex *a, const struct vertex *b);

/* Finds top, bottom and the range of x. 0: a vertex is POLYGON_FAR or more away. */
int32 sides_measure(struct sides *sides, const struct vertex *vertices, int32 count);

/* Finds apex and which side is left. 0: the polygon has no area. */
int32 sides_orient(struct sides *sides, const struct vertex *vertices, int32 count);

#endif
