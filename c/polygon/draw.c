/* From a convex polygon to its scanline table and the call that draws it.

   With gradients of the plane and sub-texel starts, all numbers that decide a pixel
   are functions of the pixel alone: x of an edge at line j is x0 + (j - j0) slope
   from the edge's upper vertex, u at pixel (i, j) is u_ref + (i - i_ref) dudx +
   (j - j_ref) dudy modulo 2^32. So it does not matter which vertex comes first, which
   side is cut or where a section begins. The model in tools/model.py does the same
   arithmetic. */
#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "polygon/sides.h"
#include "polygon/texturing.h"
#include "span/scanline.h"

/* Pixels that an edge's x may lie beyond its vertices, in 16.16: it starts and
   steps within 1/2^17, over 1,024 lines at most 0.008. */
#define EDGE_ERROR 1024

static struct scanline lines[SCENE_SIDE_MAX];

typedef void edge_routine(const struct edge_plan *plan);

/* What draws each kind of span, in the order of enum span_kind. */
static const struct {
    edge_routine *edges, *exact_edges;
    void (*scissor)(const struct scissor_plan *plan);
    void (*span)(const struct span_plan *plan);
} routines[SPAN_KINDS] = {
    {edge_flat, edge_flat_exact, scissor_flat, span_fill},
    {edge_addx, edge_addx_exact, scissor_addx, span_affine_addx},
    {edge_addx, edge_addx_exact, scissor_addx, span_affine_addx_wrap},
    {edge_swap, edge_plain_exact, scissor_plain, span_affine_swap},
    {edge_swap, edge_plain_exact, scissor_plain, span_affine_c}
};

static int32 minimum(int32 a, int32 b)
{
    return a < b ? a : b;
}

static int32 maximum(int32 a, int32 b)
{
    return a > b ? a : b;
}

static void count_pixels(uint32 *pixels, int32 count)
{
    const struct scanline *line = lines;

    for (; count > 0; count--, line++)
        if (line->count > 0)
            *pixels += (uint32)line->count;
}

/* The vertices with x and y cut to whole pixels. */
static const struct vertex *whole_pixels(const struct vertex *from, int32 count)
{
    static struct vertex cut[POLYGON_VERTICES_MAX];

    for (int32 i = 0; i < count; i++) {
        cut[i] = from[i];
        cut[i].x &= ~0xffff;
        cut[i].y &= ~0xffff;
    }
    return cut;
}

static int32 is_inside_frame(const struct rectangle *box)
{
    return box->left < box->right && box->top < box->bottom;
}

enum polygon_result polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                 int32 count, const struct material *material,
                                 enum form form, struct draw_counts *counts)
{
    static struct edge left[POLYGON_VERTICES_MAX], right[POLYGON_VERTICES_MAX];
    static struct side_edge left_from[POLYGON_VERTICES_MAX], right_from[POLYGON_VERTICES_MAX];
    struct sides sides;
    struct rectangle box;
    struct texturing texturing;
    struct edge_plan edges;
    struct span_plan span;
    enum span_kind kind;
    int32 cut;

    if (count < 3 || count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (material->edges == EDGES_INTEGER)
        vertices = whole_pixels(vertices, count);
    if (!sides_measure(&sides, vertices, count))
        return POLYGON_OUTSIDE_RANGE;
    box.left = maximum(fix_ceil(sides.x_low - EDGE_ERROR), 0);
    box.right = minimum(fix_ceil(sides.x_high + EDGE_ERROR), frame->width);
    box.top = maximum(fix_ceil(vertices[sides.top].y), 0);
    box.bottom = minimum(fix_ceil(vertices[sides.bottom].y), frame->height);
    if (!is_inside_frame(&box) || !sides_orient(&sides, vertices, count))
        return POLYGON_EMPTY;

    edges.lines = lines;
    edges.left = left;
    edges.right = right;
    edges.lefts = edges_make(left, left_from, &sides, vertices, count, sides.left_step,
                             box.top, box.bottom, material->edges);
    edges.rights = edges_make(right, right_from, &sides, vertices, count, -sides.left_step,
                              box.top, box.bottom, material->edges);
    cut = sides.x_low < 0 || sides.x_high + EDGE_ERROR > (frame->width << 16);

    span.lines = lines;
    span.count = box.bottom - box.top;
    span.row = frame->pixels + box.top * frame->pitch - EDGE_BIAS;
    span.pitch = frame->pitch;
    span.map = material->map;
    span.colour = material->colour;
    kind = SPAN_FILL;
    if (material->map) {
        if (material->gradients == GRADIENTS_PLANE) {
            if (!texturing_plane(&texturing, vertices, &sides, &box, material->start))
                return POLYGON_EMPTY;
        } else {
            if (count != 3)
                return POLYGON_NO_TRIANGLE;
            texturing_longest(&texturing, vertices, &sides, &box);
        }
        texturing_edges(&texturing, left, left_from, edges.lefts, material->gradients,
                        material->start);
        span.dudx = texturing.dudx;
        span.dvdx = texturing.dvdx;
        edges.dudx = edges.dvdx = 0;
        if (material->start == START_SUBTEXEL) {
            edges.dudx = span.dudx;
            edges.dvdx = span.dvdx;
        }
        kind = form == FORM_SWAP ? SPAN_AFFINE_SWAP
             : form == FORM_C ? SPAN_AFFINE_C
             : texturing.wraps ? SPAN_AFFINE_ADDX_WRAP : SPAN_AFFINE_ADDX;
    }

    if (material->edges == EDGES_EXACT)
        routines[kind].exact_edges(&edges);
    else
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
