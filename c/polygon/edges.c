#include "polygon/edges.h"

#include "math/math.h"

/* Returns the number of lines of an edge, from the first at or below its upper vertex. */
static int32 lines_of(const struct edge *edge)
{
    return FIX_CEIL(edge->lower->y) - FIX_CEIL(edge->upper->y);
}

fix16 edge_slope(const struct edge *edge)
{
    if (lines_of(edge) <= 1)    /* never stepped; with more lines height > 1: no overflow */
        return 0;
    return mul_div(edge->lower->x - edge->upper->x, 65536, edge->lower->y - edge->upper->y);
}

fix16 edge_x(const struct edge *edge)
{
    const struct vertex *upper = edge->upper, *lower = edge->lower;

    return upper->x + mul_div(lower->x - upper->x, (edge->top << 16) - upper->y,
                              lower->y - upper->y);
}

uint32 lines_pixels(const struct scanline *line, int32 count)
{
    uint32 pixels = 0;

    for (; count > 0; count--, line++)
        if (line->last >= line->left)
            pixels += (uint32)(line->last - line->left + 1);
    return pixels;
}
