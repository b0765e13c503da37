/* Many polygons of one material. */
#include "drawing/deep.h"
#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/three.h"
#include "triangle/triangles.h"

/* Returns non-zero if polygons of the material are drawn this way with all rules on. */
static int32 is_plain(const struct renderer *renderer, const struct material *material)
{
    const struct frame *frame = renderer->frame;
    const struct map *map = material->map;

    return material->perspective && material->mapper == MAPPER_AFFINE && !material->tolerance
        && material->edges != EDGES_SNAPPED && !material->whole && material->gradients == GRADIENTS_PLANE
        && (material->clip == CLIP_SCISSOR || material->edges == EDGES_EXACT)
        && !renderer->counts && !renderer->only_counts && !renderer->off && renderer->form == FORM_ADDX
        && frame->pixel_bytes == 1 && frame->pitch == (int16)frame->pitch
        && map && map->layout == MAP_PAGE && map->texel_bytes == 1;
}

/* Sets what the frame and the material decide. Returns 0 if polygon_draw_inside draws the material's polygons: other
   mappers, no perspective, a tolerance, EDGES_SNAPPED, rounded edges with CLIP_VERTICES, pixels of more than a byte,
   another form, a rule is off, polygons are counted, or the pitch is not an int16. */
static int32 deep_set(struct deep *deep, struct renderer *renderer, const struct material *material)
{
    const struct frame *frame = renderer->frame;
    struct setup *s = &deep->s;

    if (!is_plain(renderer, material))
        return 0;
    s->renderer = renderer;
    s->scratch = renderer->scratch;
    setup_edges_set(s);
    s->frame = frame;
    s->material = material;
    s->form = FORM_ADDX;
    s->off = s->applied = 0;
    s->counts = 0;
    s->kind = SPAN_PERSPECTIVE;
    s->affine = SPAN_AFFINE_ADDX_WRAP;
    s->setting = (enum perspective)material->perspective;
    s->perspective = &deep->plan;
    s->texturing.u_cut = s->texturing.v_cut = 0;
    s->span.lines = s->edges.lines;
    s->span.pitch = frame->pitch;
    s->span.map = material->map->texels;
    deep->takes = material_takes_vertices(material);
    deep->exact = material->edges == EDGES_EXACT;
    deep->saved = s->setting == PERSPECTIVE_EVERY16 ? PERSPECTIVE_SAVED_EVERY16 : PERSPECTIVE_SAVED_EVERY8;
    deep->row = frame->pixels - EDGE_BIAS;
    deep->right = perspective_has_pieces(s->setting) && renderer->reciprocals ? (uint32)frame->width << 16 : 0;
    return 1;
}

/* Returns non-zero if the polygon is drawn whole: not as a fan of triangles. */
static inline int32 is_whole(const struct renderer *renderer, const struct polygon *polygon)
{
    return polygon->count == 3
        || (is_polygon(polygon) && (polygon->planar == PLANAR_ALL
                                    || polygon_is_planar(renderer, polygon, polygon->vertices, PLANAR_DEPTHS)));
}

/* Draws a polygon of the plan's material. */
static inline enum polygon_result deep_one(struct deep *deep, const struct polygon *polygon)
{
    struct setup *s = &deep->s;
    int32 result = DEEP_CONSTANT;

    if (is_whole(s->renderer, polygon)) {
        s->given = s->vertices = polygon->vertices;
        s->count = polygon->count;
        if (!deep->takes)
            s->vertices = material_made(s->scratch->vertices, s->given, s->count, s->material);
        result = deep_draw(deep);
    }
    return result == DEEP_CONSTANT ? polygon_draw_inside(s->renderer, polygon, s->material)
                                   : (enum polygon_result)result;
}

/* As polygons_draw, for a material with perspective. */
static enum polygon_result deep_run(struct deep *deep, struct renderer *renderer, const struct polygon *polygons,
                                    const struct polygon *end, const struct material *material)
{
    enum polygon_result result, refused = POLYGON_DRAWN;
    const int32 is_set = deep_set(deep, renderer, material);

    for (; polygons < end; polygons++) {
        if (begins_outside(renderer, polygons))
            result = polygon_draw_beyond(renderer, polygons, material);
        else
            result = is_set ? deep_one(deep, polygons) : polygon_draw_inside(renderer, polygons, material);
        refused = result > POLYGON_EMPTY ? result : refused;
    }
    return refused;
}

enum polygon_result polygon_draw_deep(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material)
{
    struct deep deep;

    return deep_set(&deep, renderer, material) ? deep_one(&deep, polygon)
                                               : polygon_draw_inside(renderer, polygon, material);
}

enum polygon_result polygons_draw(struct renderer *renderer, const struct polygon *polygons,
                                  int32 count, const struct material *material)
{
    enum polygon_result result, refused = POLYGON_DRAWN;
    union {                     /* one at a time */
        struct three three;
        struct deep deep;
    } plan;
    struct three *const three = &plan.three;
    const struct polygon *const end = polygons + count;
    int32 is_set;

    if (material->edges == EDGES_SNAPPED && renderer->triangles && !renderer->counts)
        return renderer->triangles->run(renderer, polygons, count, material, polygon_draw_whole);
    is_set = three_set(three, renderer, material);
    if (!is_set && material->perspective)
        return deep_run(&plan.deep, renderer, polygons, end, material);
    for (;; polygons++) {
        if (is_set && three->vertices != THREE_MADE)
            polygons = three_run(three, polygons, end);
        if (polygons == end)
            return refused;
        if (begins_outside(renderer, polygons))
            result = polygon_draw_beyond(renderer, polygons, material);
        else if (is_set && polygons->count == 3)
            result = three_polygon(three, polygons->vertices);
        else
            result = polygon_draw_inside(renderer, polygons, material);
        refused = result > POLYGON_EMPTY ? result : refused;
    }
}
