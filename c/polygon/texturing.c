#include "polygon/texturing.h"

#include "polygon/math.h"

/* The difference a - b of x, y, s and t. */
static void vertex_difference(struct vertex *out, const struct vertex *a, const struct vertex *b)
{
    out->x = a->x - b->x;
    out->y = a->y - b->y;
    out->s = a->s - b->s;
    out->t = a->t - b->t;
}

/* part * 65536 / whole, or the largest step: a narrow triangle's may be any. */
static fix16 saturated_step(fix16 part, fix16 whole)
{
    const fix16 largest = 0x7fffffff;

    if (fix_magnitude(part) >> 15 >= fix_magnitude(whole))
        return (part < 0) == (whole < 0) ? largest : -largest;
    return whole < 0 ? mul_div(-part, 65536, -whole) : mul_div(part, 65536, whole);
}

void texturing_longest(struct texturing *t, const struct sides *sides,
                       const struct rectangle *box, enum chain chain)
{
    const struct vertex *top = sides->top, *bottom = sides->bottom, *middle = sides->apex;
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
    t->dudx &= (fix16)~t->spare;
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

/* The other way: the plane's values where the edge crosses the lines. */
static void to_crossing(const struct texturing *t, struct edge *edge)
{
    fix16 prestep = (fix16)((edge->x - EDGE_BIAS) << 16) - edge_x(edge);
    fix16 slope = edge_slope(edge);

    edge->u -= (uint32)mul_fix(t->dudx, prestep);
    edge->v -= (uint32)mul_fix(t->dvdx, prestep);
    edge->du = t->dudy + mul_fix(t->dudx, slope);
    edge->dv = t->dvdy + mul_fix(t->dvdx, slope);
}

void texturing_edges(const struct texturing *t, struct edge *edges, int32 count,
                     enum gradients gradients, enum start start)
{
    if (gradients == GRADIENTS_PLANE) {
        texturing_starts(t, edges, count);
        if (start == START_SUBTEXEL)
            return;
    }
    for (; count > 0; count--, edges++) {
        if (gradients == GRADIENTS_PLANE) {
            to_crossing(t, edges);
        } else {
            texturing_along(edges);
            if (start == START_SUBTEXEL)
                to_pixels(t, edges);
        }
        edges->u = (edges->u & ~t->spare) | t->guard;
        edges->du &= (fix16)~t->spare;
    }
}
