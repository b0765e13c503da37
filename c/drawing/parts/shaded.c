/* Gouraud's triangles: those of one shade are flat. */
#include "drawing/outline.h"
#include "drawing/three.h"

static void set_way(struct three *three, enum span_kind kind, int32 chain, enum three_way way)
{
    three->s.kind = kind;
    three->chain = chain;
    three->way = way;
    three_set_lines(three);
}

/* Draws a Gouraud triangle of one shade. */
static enum polygon_result draw_flat(struct three *three, const struct vertex *vertices,
                                     uint32 colour)
{
    const int32 chain = three->chain;
    const enum three_way way = (enum three_way)three->way;
    enum polygon_result result;

    three->s.span.colour = colour;
    set_way(three, SPAN_FILL, OUTLINE_ALONE, THREE_FLAT);
    result = three_draw(three, vertices);
    set_way(three, SPAN_GOURAUD, chain, way);
    return result;
}

enum polygon_result three_shaded(struct three *three, const struct vertex *given, const struct vertex *made)
{
    const uint32 shade = (uint32)given->shade >> 16;

    return shade == (uint32)given[1].shade >> 16 && shade == (uint32)given[2].shade >> 16
         ? draw_flat(three, made, shade) : three_draw(three, made);
}
