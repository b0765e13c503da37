/* From a convex polygon to its scanline table and the call that draws it.

   All numbers that decide a pixel are functions of the pixel alone: x of an edge
   at line j is x0 + (j - j0) slope from the edge's upper vertex, u at pixel (i, j)
   is u_ref + (i - i_ref) dudx + (j - j_ref) dudy modulo 2^32. So it does not matter
   which vertex comes first, which side is cut or where a section begins. The model
   in tools/model.py does the same arithmetic. */
#include "polygon/plane.h"
#include "polygon/polygon.h"
#include "polygon/sides.h"
#include "span/scanline.h"

/* Pixels that an edge's x may lie beyond its vertices, in 16.16: it starts and
   steps within 1/2^17, over 1,024 lines at most 0.008. */
#define EDGE_ERROR 1024

/* 128 texels a pixel in 16.16: faster steps alias with the map's period. */
#define STEP_HALF_PERIOD 0x800000

static struct scanline lines[SCENE_SIDE_MAX];

/* What draws each kind of span, in the order of enum span_kind. */
static const struct {
    void (*edges)(const struct edge_plan *plan);
    void (*scissor)(const struct scissor_plan *plan);
    void (*span)(const struct span_plan *plan);
} routines[SPAN_KINDS] = {
    {edge_flat, scissor_flat, span_fill},
    {edge_addx, scissor_addx, span_affine_addx},
    {edge_addx, scissor_addx, span_affine_addx_wrap},
    {edge_swap, scissor_swap, span_affine_swap},
    {edge_swap, scissor_swap, span_affine_c}
};

struct texturing {
    fix16 dudx, dudy, dvdx, dvdy;       /* texels, modulo 2^32 */
    uint32 u, v;                        /* at pixel (i, j) */
    int32 i, j;
    int32 wraps;                        /* v may wrap more than once in a span */
};

struct rectangle {
    int32 left, top, right, bottom;     /* pixels; right and bottom excluded */
};

static int32 minimum(int32 a, int32 b)
{
    return a < b ? a : b;
}

static int32 maximum(int32 a, int32 b)
{
    return a > b ? a : b;
}

/* A 32.32 gradient as a 16.16 step, rounded to the nearest; spare bits below stay 0. */
static fix16 step(const struct wide *gradient, int32 spare)
{
    uint32 half = (uint32)0x8000 << spare;
    uint32 lo = gradient->lo + half;
    uint32 hi = (uint32)gradient->hi + (lo < half);

    return (fix16)(((hi << 16) | (lo >> 16)) >> spare << spare);
}

static int32 magnitude(fix16 value)
{
    return value < 0 ? -value : value;
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

/* The plane through top, bottom and apex as steps and the coordinates at one pixel in the box. */
static int32 set_texturing(struct texturing *t, const struct vertex *vertices,
                           const struct sides *sides, const struct rectangle *box)
{
    const struct vertex *a = &vertices[sides->top];
    struct vertex e1, e2;
    struct plane plane;
    int32 x, y, spare;

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

    /* Where v wraps in a span, the addx chain carries into u's lowest bit: one wrap
       is caught by keeping that bit spare. More wraps need the longer loop. */
    t->wraps = 0;
    spare = 0;
    if (!inside_period(t, box)) {
        int32 speed = magnitude(chain_step(t->dvdx));

        if (((speed >> 8) + 1) * (box->right - box->left) <= 0x10000)
            spare = 1;
        else
            t->wraps = 1;
    }
    t->dudx = step(&plane.dsdx, spare);
    t->dudy = step(&plane.dsdy, spare);
    if (spare)
        t->u = (t->u & ~(uint32)1) | (chain_step(t->dvdx) < 0);
    return 1;
}

/* u and v at the first pixel of each left edge. */
static void place_edges(struct edge *edge, int32 edges, const struct texturing *t, int32 top)
{
    uint32 y = (uint32)(top - t->j);

    for (; edges > 0; edges--, edge++) {
        uint32 x = (((uint32)edge->x + 0xffff) >> 16) - EDGE_BIAS - (uint32)t->i;

        edge->u = t->u + x * (uint32)t->dudx + y * (uint32)t->dudy;
        edge->v = t->v + x * (uint32)t->dvdx + y * (uint32)t->dvdy;
        y += (uint32)edge->lines;
    }
}

static void count_pixels(uint32 *pixels, int32 count)
{
    const struct scanline *line = lines;

    for (; count > 0; count--, line++)
        if (line->count > 0)
            *pixels += (uint32)line->count;
}

enum polygon_result polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                 int32 count, const struct material *material,
                                 enum form form, struct draw_counts *counts)
{
    static struct edge left[POLYGON_VERTICES_MAX], right[POLYGON_VERTICES_MAX];
    struct sides sides;
    struct rectangle box;
    struct texturing texturing;
    struct edge_plan edges;
    struct span_plan span;
    enum span_kind kind;
    int32 cut;

    if (count < 3 || count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (!sides_measure(&sides, vertices, count))
        return POLYGON_OUTSIDE_RANGE;
    box.left = maximum(fix_ceil(sides.x_low - EDGE_ERROR), 0);
    box.right = minimum(fix_ceil(sides.x_high + EDGE_ERROR), frame->width);
    box.top = maximum(fix_ceil(vertices[sides.top].y), 0);
    box.bottom = minimum(fix_ceil(vertices[sides.bottom].y), frame->height);
    if (box.left >= box.right || box.top >= box.bottom)
        return POLYGON_EMPTY;
    if (!sides_orient(&sides, vertices, count))
        return POLYGON_EMPTY;

    edges.lines = lines;
    edges.left = left;
    edges.right = right;
    edges.lefts = sides_edges(left, &sides, vertices, count, sides.left_step,
                              box.top, box.bottom);
    edges.rights = sides_edges(right, &sides, vertices, count, -sides.left_step,
                               box.top, box.bottom);
    cut = sides.x_low < 0 || sides.x_high + EDGE_ERROR > (frame->width << 16);

    span.lines = lines;
    span.count = box.bottom - box.top;
    span.row = frame->pixels + box.top * frame->pitch - EDGE_BIAS;
    span.pitch = frame->pitch;
    span.map = material->map;
    span.colour = material->colour;
    if (material->map) {
        if (!set_texturing(&texturing, vertices, &sides, &box))
            return POLYGON_EMPTY;
        place_edges(left, edges.lefts, &texturing, box.top);
        edges.dudx = span.dudx = texturing.dudx;
        edges.dvdx = span.dvdx = texturing.dvdx;
        edges.dudy = texturing.dudy;
        edges.dvdy = texturing.dvdy;
        kind = form == FORM_SWAP ? SPAN_AFFINE_SWAP
             : form == FORM_C ? SPAN_AFFINE_C
             : texturing.wraps ? SPAN_AFFINE_ADDX_WRAP : SPAN_AFFINE_ADDX;
    } else {
        kind = SPAN_FILL;
    }

    routines[kind].edges(&edges);
    if (cut) {
        struct scissor_plan scissor;

        scissor.lines = lines;
        scissor.count = span.count;
        scissor.width = frame->width;
        scissor.dudx = span.dudx;
        scissor.dvdx = span.dvdx;
        routines[kind].scissor(&scissor);
    }
    if (counts) {
        counts->polygons++;
        count_pixels(&counts->pixels[kind], span.count);
    }
    routines[kind].span(&span);
    return POLYGON_DRAWN;
}
