#include "polygon/edges.h"

#include "polygon/plane.h"

/* Lines of an edge, from the first at or below its upper vertex. */
static int32 lines_of(const struct side_edge *from)
{
    return FIX_CEIL(from->lower->y) - FIX_CEIL(from->upper->y);
}

fix16 edge_slope(const struct side_edge *from)
{
    if (lines_of(from) <= 1)    /* never stepped; more lines: height above 1, no overflow */
        return 0;
    return mul_div(from->lower->x - from->upper->x, 65536, from->lower->y - from->upper->y);
}

fix16 edge_x(const struct side_edge *from)
{
    const struct vertex *upper = from->upper, *lower = from->lower;
    int32 first = FIX_CEIL(upper->y);
    fix16 x = upper->x + mul_div(lower->x - upper->x, (first << 16) - upper->y,
                                 lower->y - upper->y);

    if (from->top > first)      /* the frame begins further down */
        x += (fix16)((uint32)(from->top - first) * (uint32)edge_slope(from));
    return x;
}

int32 edges_make(struct edge *edges, struct side_edge *from, const struct sides *sides,
                 const struct vertex *vertices, int32 count, int32 step,
                 int32 top, int32 bottom, enum edges kind)
{
    const struct vertex *upper = &vertices[sides->top], *lower;
    int32 i = sides->top, found = 0;

    while (top < bottom) {
        int32 end;

        i += step;
        if (i < 0)
            i = count - 1;
        else if (i == count)
            i = 0;
        lower = &vertices[i];
        end = FIX_CEIL(lower->y);
        if (end > bottom)
            end = bottom;
        if (end > top && lower->y > upper->y) {
            from->upper = upper;
            from->lower = lower;
            from->top = top;
            if (kind == EDGES_EXACT)
                edge_exact(edges, upper, lower, top);
            else
                edge_rounded(edges, upper, lower, top);
            edges->lines = end - top;
            top = end;
            edges++;
            from++;
            found++;
        }
        upper = lower;
    }
    return found;
}
