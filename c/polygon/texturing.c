#include "polygon/texturing.h"

#include "polygon/plane.h"

static int32 magnitude(fix16 value)
{
    return value < 0 ? -value : value;
}

/* A 32.32 gradient as a 16.16 step, rounded to the nearest; spare bits below stay 0. */
static fix16 step(const struct wide *gradient, uint32 spare)
{
    uint32 half = (uint32)0x8000 << spare;
    uint32 lo = gradient->lo + half;
    uint32 hi = (uint32)gradient->hi + (lo < half);

    return (fix16)(((hi << 16) | (lo >> 16)) & ~spare);
}

/* dv as the addx chain steps it: modulo 256 texels, -128 to 128. */
static fix16 chain_step(fix16 dv)
{
    return (fix16)((uint32)dv << 8) >> 8;
}

/* Whether v stays between two multiples of 256 texels on the whole box. */
static int32 inside_period(const struct texturing *t, const struct rectangle *box)
{
    uint32 travel_x = (uint32)magnitude(t->dvdx) >> 8, travel_y = (uint32)magnitude(t->dvdy) >> 8;
    uint32 travel, v = (t->v >> 8) & 0xffff;            /* 8.8 */

    if (travel_x >= 0x10000 || travel_y >= 0x10000)
        return 0;
    travel = (travel_x + 1) * ((uint32)(box->right - box->left + 1) >> 1)
           + (travel_y + 1) * ((uint32)(box->bottom - box->top + 1) >> 1) + 1;
    return v >= travel && v + travel < 0x10000;
}

/* Where v wraps in a span, the addx chain carries into u's lowest bit: one wrap is
   caught by keeping that bit spare. More wraps need the longer loop. */
static void plan_wrap(struct texturing *t, const struct rectangle *box, int32 inside)
{
    int32 speed = magnitude(chain_step(t->dvdx));

    t->wraps = 0;
    t->spare = 0;
    if (!inside) {
        if (((speed >> 8) + 1) * (box->right - box->left) <= 0x10000)
            t->spare = 1;
        else
            t->wraps = 1;
    }
    t->guard = t->spare & (chain_step(t->dvdx) < 0);
}

int32 texturing_plane(struct texturing *t, const struct vertex *vertices,
                      const struct sides *sides, const struct rectangle *box,
                      enum start start, int32 chained)
{
    const struct vertex *a = &vertices[sides->top];
    struct vertex e1, e2;
    struct plane plane;
    int32 x, y;

    vertex_difference(&e1, &vertices[sides->bottom], a);
    vertex_difference(&e2, &vertices[sides->apex], a);
    if (gradients(&e1, &e2, &plane) == 0)
        return 0;
    t->i = (box->left + box->right) >> 1;
    t->j = (box->top + box->bottom) >> 1;
    x = (fix16)((uint32)t->i << 16) - a->x;
    y = (fix16)((uint32)t->j << 16) - a->y;
    t->u = (uint32)a->s + (uint32)wide_mul(&plane.dsdx, x) + (uint32)wide_mul(&plane.dsdy, y);
    t->v = (uint32)a->t + (uint32)wide_mul(&plane.dtdx, x) + (uint32)wide_mul(&plane.dtdy, y);
    t->dvdx = step(&plane.dtdx, 0);
    t->dvdy = step(&plane.dtdy, 0);
    plan_wrap(t, box, !chained || (start == START_SUBTEXEL && inside_period(t, box)));
    t->dudx = step(&plane.dsdx, t->spare);
    t->dudy = step(&plane.dsdy, t->spare);
    t->u = (t->u & ~t->spare) | t->guard;
    return 1;
}

/* part * 65536 / whole, or the largest step: a narrow triangle's may be any. */
static fix16 saturated_step(fix16 part, fix16 whole)
{
    const fix16 largest = 0x7fffffff;

    if (magnitude(part) >> 15 >= magnitude(whole))
        return (part < 0) == (whole < 0) ? largest : -largest;
    return whole < 0 ? mul_div(-part, 65536, -whole) : mul_div(part, 65536, whole);
}

void texturing_longest(struct texturing *t, const struct vertex *vertices,
                       const struct sides *sides, const struct rectangle *box,
                       int32 chained)
{
    const struct vertex *top = &vertices[sides->top], *bottom = &vertices[sides->bottom];
    const struct vertex *middle = &vertices[sides->apex];
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
    plan_wrap(t, box, !chained);
    t->dudx &= (fix16)~t->spare;
}

/* On the plane, u and v are functions of the pixel. */
static void on_plane(const struct texturing *t, struct edge *edge, const struct side_edge *from)
{
    uint32 x = edge->x - EDGE_BIAS - (uint32)t->i, y = (uint32)(from->top - t->j);

    edge->u = t->u + x * (uint32)t->dudx + y * (uint32)t->dudy;
    edge->v = t->v + x * (uint32)t->dvdx + y * (uint32)t->dvdy;
    edge->du = t->dudy + (fix16)((uint32)edge->whole * (uint32)t->dudx);
    edge->dv = t->dvdy + (fix16)((uint32)edge->whole * (uint32)t->dvdx);
}

void texturing_along(struct edge *edge, const struct side_edge *from)
{
    const struct vertex *upper = from->upper;
    fix16 y = (from->top << 16) - upper->y;
    struct vertex whole;

    vertex_difference(&whole, from->lower, upper);
    edge->u = (uint32)(upper->s + mul_div(whole.s, y, whole.y));
    edge->v = (uint32)(upper->t + mul_div(whole.t, y, whole.y));
    edge->du = edge->dv = 0;
    if (edge->lines > 1) {              /* so the height is above 1: no overflow */
        edge->du = mul_div(whole.s, 65536, whole.y);
        edge->dv = mul_div(whole.t, 65536, whole.y);
    }
}

/* Moves u and v from where the edge crosses the lines to the first pixels. */
static void to_pixels(const struct texturing *t, struct edge *edge, fix16 x, fix16 slope)
{
    fix16 prestep = (fix16)((edge->x - EDGE_BIAS) << 16) - x;
    fix16 step = (edge->whole << 16) - slope;

    edge->u += (uint32)mul_fix(t->dudx, prestep);
    edge->v += (uint32)mul_fix(t->dvdx, prestep);
    edge->du += mul_fix(t->dudx, step);
    edge->dv += mul_fix(t->dvdx, step);
}

/* The other way: the plane's values where the edge crosses the lines. */
static void to_crossing(const struct texturing *t, struct edge *edge, fix16 x, fix16 slope)
{
    fix16 prestep = (fix16)((edge->x - EDGE_BIAS) << 16) - x;

    edge->u -= (uint32)mul_fix(t->dudx, prestep);
    edge->v -= (uint32)mul_fix(t->dvdx, prestep);
    edge->du = t->dudy + mul_fix(t->dudx, slope);
    edge->dv = t->dvdy + mul_fix(t->dvdx, slope);
}

void texturing_edges(const struct texturing *t, struct edge *edge,
                     const struct side_edge *from, int32 count,
                     enum gradients gradients, enum start start)
{
    for (; count > 0; count--, edge++, from++) {
        if (gradients == GRADIENTS_PLANE) {
            on_plane(t, edge, from);
            if (start == START_TRUNCATED)
                to_crossing(t, edge, edge_x(from), edge_slope(from));
        } else {
            texturing_along(edge, from);
            if (start == START_SUBTEXEL)
                to_pixels(t, edge, edge_x(from), edge_slope(from));
        }
        edge->u = (edge->u & ~t->spare) | t->guard;
        edge->du &= (fix16)~t->spare;
    }
}
