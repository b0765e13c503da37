/* Starts beside those of the plane at the first pixels. */
#include "drawing/ways.h"
#include "math/math.h"

/* With steps of this many texels or more, shortfall returns 0. */
#define STEEP_256 256

/* Returns the units by which u may fall short along a left edge and the lines that begin there. The
   step g is below `whole`; the longest line is a pixel or wider. Along the edge u is off by half a
   unit a line. Presteps are rounded down, and x is off by half a unit a line, which adds g times
   that. The step is off by half of `coarse` a pixel and by (1 + g) / w units of the longest line's
   width w; a line has w + 2 steps at most, 3 w. */
static uint32 shortfall(fix16 step, uint32 cut, int32 lines, int32 width)
{
    const int32 whole = (int32)(fix_magnitude(step) >> 16) + 2;
    const int32 coarse = cut ? (1 << cut) + 1 : 1;

    if (whole > STEEP_256)
        return 0;
    return (uint32)((lines * (3 + whole) + (width + 1) * coarse) >> 1) + 4 * (uint32)whole + 4;
}

/* Moves u and v from where the edge crosses the lines to the first pixels. */
static void to_pixels(const struct texturing *t, struct edge *edge)
{
    fix16 prestep = (fix16)((edge->x - EDGE_BIAS) << 16) - edge_x(edge);
    fix16 step = (edge->whole << 16) - edge_slope(edge);

    edge->u += (uint32)mul_fix(t->dudx, prestep);
    edge->v += (uint32)mul_fix(t->dvdx, prestep);
    edge->du += mul_fix(t->dudx, step);
    edge->dv += mul_fix(t->dvdx, step);
}

/* Moves u and v back from the first pixels to where the edge crosses the lines. */
static void to_crossing(const struct texturing *t, struct edge *edge)
{
    fix16 prestep = (fix16)((edge->x - EDGE_BIAS) << 16) - edge_x(edge);
    fix16 slope = edge_slope(edge);

    edge->u -= (uint32)mul_fix(t->dudx, prestep);
    edge->v -= (uint32)mul_fix(t->dvdx, prestep);
    edge->du = t->dudy + mul_fix(t->dudx, slope);
    edge->dv = t->dvdy + mul_fix(t->dvdx, slope);
}

/* Raises an edge's start and steps to what the spans keep. */
static void raise_edge(const struct texturing *t, struct edge *edge)
{
    edge->u = texturing_raised(edge->u, t->u_cut) | t->wrap_bit;
    edge->v = texturing_raised(edge->v, t->v_cut);
    edge->du = (fix16)texturing_raised((uint32)edge->du, t->u_cut);
    edge->dv = (fix16)texturing_raised((uint32)edge->dv, t->v_cut);
}

void texturing_crossings(const struct texturing *t, struct edge *edges, int32 count)
{
    for (; count > 0; count--, edges++) {
        to_crossing(t, edges);
        raise_edge(t, edges);
    }
}

void texturing_pixels(const struct texturing *t, struct edge *edges, int32 count, int32 width)
{
    for (; count > 0; count--, edges++) {
        texturing_along(edges);
        to_pixels(t, edges);
        edges->u += shortfall(t->dudx, t->u_cut, edges->lines, width);
        edges->v += shortfall(t->dvdx, t->v_cut, edges->lines, width);
        raise_edge(t, edges);
    }
}
