/* A corner of a polygon on the screen, in scene files too. */
#ifndef VERTEX_H
#define VERTEX_H

#include "compiler.h"

/* x, y: pixels, pixel centres at integers, -POLYGON_FAR to POLYGON_FAR (excluded); y and t
   downwards. s, t: 0 to 256 along the longer side of the map, whatever its size; if the map
   repeats, any value in the range of x and y. shade: 0 to 255: MAPPER_GOURAUD's pixel, or 4 times
   the level of light. w: depth, W_MIN to W_MAX, used only with perspective. All 16.16. */
struct vertex {
    fix16 x, y, s, t, shade, w;
};

enum { VERTEX_FIELDS = sizeof(struct vertex) / sizeof(fix16) };

/* Sets *least to the least value of a field of vertices; returns the greatest less the least.
   value: the first vertex's field. */
fix16 vertex_range(const fix16 *value, int32 count, fix16 *least);

enum vertex_limits {
    POLYGON_FAR = 16384,        /* pixels: differences stay inside 16.16 */
    W_MIN = 1 << 8,             /* 1/256 ... */
    W_MAX = 1 << 30             /* ... to 16,384: 22 bits apart in one polygon */
};

#endif
