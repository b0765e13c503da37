/* From a convex polygon to its scanline table and the call that draws it.

   With gradients of the plane and sub-texel starts, all numbers that decide a pixel
   are functions of the pixel alone: x of an edge at line j is x0 + (j - j0) slope
   from the edge's upper vertex, u at pixel (i, j) is u_ref + (i - i_ref) dudx +
   (j - j_ref) dudy modulo 2^32. So it does not matter which vertex comes first, which
   side is cut or where a section begins. The model in tools/model.py does the same
   arithmetic. */
#include "polygon/edges.h"
#include "polygon/plane.h"
#include "polygon/polygon.h"
#include "polygon/sides.h"
#include "polygon/texturing.h"
#include "span/scanline.h"

/* Pixels that an edge's x may lie beyond its vertices, in 16.16: it starts and
   steps within 1/2^17, over 1,024 lines at most 0.008. */
#define EDGE_ERROR 1024

static struct scanline lines[SCENE_SIDE_MAX];
static uint32 code[CODE_BYTES / 4];     /* of span_generated, at whole longwords */

typedef void edge_routine(const struct edge_plan *plan);

/* What draws each kind of span, in the order of enum span_kind. */
static const struct {
    edge_routine *edges, *exact_edges;
    void (*scissor)(const struct scissor_plan *plan);
    void (*span)(const struct span_plan *plan);
} routines[SPAN_KINDS] = {
    [SPAN_FILL] = {edge_flat, edge_flat_exact, scissor_flat, span_fill},
    [SPAN_GOURAUD] = {edge_plain, edge_plain_exact, scissor_plain, span_gouraud},
    [SPAN_AFFINE_ADDX] = {edge_addx, edge_addx_exact, scissor_addx, span_affine_addx},
    [SPAN_AFFINE_ADDX_WRAP] = {edge_addx, edge_addx_exact, scissor_addx,
                               span_affine_addx_wrap},
    [SPAN_AFFINE_SWAP] = {edge_swap, edge_plain_exact, scissor_plain, span_affine_swap},
    [SPAN_AFFINE_C] = {edge_swap, edge_plain_exact, scissor_plain, span_affine_c},
    [SPAN_ARBITRARY] = {edge_plain, edge_plain_exact, scissor_plain, span_arbitrary},
    [SPAN_GENERATED] = {edge_plain, edge_plain_exact, scissor_plain, span_generated}
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

/* The vertices as the set-up takes them: x and y in whole pixels where edges are, s and
   t in texels (rounded down to 1/65536) or the shade instead. */
static const struct vertex *adapt(const struct vertex *from, int32 count,
                                  const struct material *material)
{
    static struct vertex to[POLYGON_VERTICES_MAX];
    fix16 scale = material->map ? material->map->scale : 65536;

    if (material->edges != EDGES_INTEGER && scale == 65536
        && material->mapper != MAPPER_GOURAUD)
        return from;
    for (int32 i = 0; i < count; i++) {
        to[i] = from[i];
        if (material->edges == EDGES_INTEGER) {
            to[i].x &= ~0xffff;
            to[i].y &= ~0xffff;
        }
        if (material->mapper == MAPPER_GOURAUD) {
            to[i].s = from[i].shade;
            to[i].t = 0;
        } else if (scale != 65536) {
            to[i].s = mul_fix(from[i].s, scale);
            to[i].t = mul_fix(from[i].t, scale);
        }
    }
    return to;
}

/* What draws a polygon of this material. */
static enum span_kind kind_of(const struct material *material, const struct frame *frame,
                              enum form form, int32 wraps)
{
    switch (material->mapper) {
    case MAPPER_GOURAUD:
        return SPAN_GOURAUD;
    case MAPPER_AFFINE:
        return form == FORM_SWAP ? SPAN_AFFINE_SWAP
             : form == FORM_C ? SPAN_AFFINE_C
             : wraps ? SPAN_AFFINE_ADDX_WRAP : SPAN_AFFINE_ADDX;
    case MAPPER_ARBITRARY:
        return SPAN_ARBITRARY;
    case MAPPER_TILED:
        return SPAN_TILED;
    case MAPPER_COLUMNS:
        return frame->pixel_bytes == 2 ? SPAN_COLUMNS_16 : SPAN_COLUMNS;
    case MAPPER_GENERATED:
        return SPAN_GENERATED;
    default:
        return SPAN_FILL;
    }
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
    vertices = adapt(vertices, count, material);
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
    span.colour = material->colour;
    span.code = code;
    if (material->map) {
        span.map = material->map->texels;
        span.map_width = material->map->width;
        span.map_height = material->map->height;
    }
    texturing.wraps = 0;
    if (material->mapper != MAPPER_FLAT) {
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
    }
    kind = kind_of(material, frame, form, texturing.wraps);

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
