#include "polygon/texturing.h"

#include "math/math.h"

/* With steps of this many texels or more, shortfall returns 0. */
#define STEEP_256 256

/* Sets *out to a - b: x, y, s and t. */
static void vertex_difference(struct vertex *out, const struct vertex *a, const struct vertex *b)
{
    out->x = a->x - b->x;
    out->y = a->y - b->y;
    out->s = a->s - b->s;
    out->t = a->t - b->t;
}

/* Returns part * 65536 / whole, saturated: the step of a narrow triangle may have any size. */
static fix16 saturated_step(fix16 part, fix16 whole)
{
    const fix16 largest = 0x7fffffff;

    if (fix_magnitude(part) >> 15 >= fix_magnitude(whole))
        return (part < 0) == (whole < 0) ? largest : -largest;
    return whole < 0 ? mul_div(-part, 65536, -whole) : mul_div(part, 65536, whole);
}

/* Returns step rounded to the nearest multiple of 2^cut. */
static fix16 nearest(fix16 step, uint32 cut)
{
    return (fix16)((((uint32)step + (1u << cut >> 1)) >> cut) << cut);
}

uint32 texturing_raised(uint32 value, uint32 cut)
{
    return ((value + (1u << cut) - 1) >> cut) << cut;
}

void texturing_longest(struct texturing *t, const struct sides *sides,
                       const struct rectangle *box, enum chain chain)
{
    const struct vertex *top = sides->top, *bottom = sides->bottom, *middle = sides->middle;
    struct vertex whole, part;

    vertex_difference(&whole, bottom, top);
    vertex_difference(&part, middle, top);
    if (whole.y > 0) {
        part.x -= mul_div(whole.x, part.y, whole.y);
        part.s -= mul_div(whole.s, part.y, whole.y);
        part.t -= mul_div(whole.t, part.y, whole.y);
    }
    t->dudx = t->dvdx = 0;
    if (part.x) {
        t->dudx = saturated_step(part.s, part.x);
        t->dvdx = saturated_step(part.t, part.x);
    }
    texturing_wrap(t, box, chain);
    t->dudx = nearest(t->dudx, t->u_cut);
    t->dvdx = nearest(t->dvdx, t->v_cut);
}

void texturing_along(struct edge *edge)
{
    const struct vertex *upper = edge->upper;
    fix16 y = (edge->top << 16) - upper->y;
    struct vertex whole;

    vertex_difference(&whole, edge->lower, upper);
    edge->u = (uint32)(upper->s + mul_div(whole.s, y, whole.y));
    edge->v = (uint32)(upper->t + mul_div(whole.t, y, whole.y));
    edge->du = edge->dv = 0;
    if (edge->lines > 1) {              /* so the height is above 1: no overflow */
        edge->du = mul_div(whole.s, 65536, whole.y);
        edge->dv = mul_div(whole.t, 65536, whole.y);
    }
}

/* Returns the units by which u may fall short along a left edge and the lines that begin there. The
   step g is below `whole`; the longest line is a pixel or wider. Along the edge u is off by half a
   unit a line. Presteps are rounded down, and x is off by half a unit a line, which adds g times
   that. The step is off by half of `coarse` a pixel and by (1 + g) / 2 units over the longest
   line. */
static uint32 shortfall(fix16 step, uint32 cut, int32 lines, int32 width, enum start start)
{
    const int32 whole = (int32)(fix_magnitude(step) >> 16) + 2;
    const int32 coarse = cut ? (1 << cut) + 1 : 1;
    const int32 line = start == START_SUBTEXEL ? 3 + whole : 1;

    if (whole > STEEP_256)
        return 0;
    return (uint32)((lines * line + (width + 1) * coarse) >> 1) + 2 * (uint32)whole + 2;
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

void texturing_edges(const struct texturing *t, struct edge *edges, int32 count, enum start start,
                     int32 width)
{
    for (; count > 0; count--, edges++) {
        texturing_along(edges);
        if (start == START_SUBTEXEL)
            to_pixels(t, edges);
        edges->u += shortfall(t->dudx, t->u_cut, edges->lines, width, start);
        edges->v += shortfall(t->dvdx, t->v_cut, edges->lines, width, start);
        raise_edge(t, edges);
    }
}
