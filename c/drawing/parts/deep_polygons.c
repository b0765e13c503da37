/* Polygons in perspective by a plan that is made once for their material. */
#include "drawing/deep.h"
#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/parts/named.h"

int32 deep_begin(struct deep *deep, struct renderer *renderer)
{
    const struct frame *frame = renderer->frame;
    struct setup *s = &deep->s;

    if (renderer->counts || renderer->only_counts || renderer->off || renderer->form != FORM_ADDX
        || frame->pixel_bytes != 1 || frame->pitch != (int16)frame->pitch)
        return 0;
    s->renderer = renderer;
    s->scratch = renderer->scratch;
    setup_edges_set(s);
    s->frame = frame;
    s->form = FORM_ADDX;
    s->off = s->applied = 0;
    s->counts = 0;
    s->kind = SPAN_PERSPECTIVE;
    s->affine = SPAN_AFFINE_ADDX_WRAP;
    s->perspective = &deep->plan;
    s->texturing.u_cut = s->texturing.v_cut = 0;
    s->span.lines = s->edges.lines;
    s->span.pitch = frame->pitch;
    deep->row = frame->pixels - EDGE_BIAS;
    return 1;
}

int32 deep_take(struct deep *deep, const struct material *material)
{
    const struct map *map = material->map;
    struct setup *s = &deep->s;

    if (!material->perspective || material->mapper != MAPPER_AFFINE || material->tolerance
        || material->edges == EDGES_SNAPPED || material->whole || material->gradients != GRADIENTS_PLANE
        || (material->clip != CLIP_SCISSOR && material->edges != EDGES_EXACT)
        || !map || map->layout != MAP_PAGE || map->texel_bytes != 1)
        return 0;
    s->material = material;
    s->setting = (enum perspective)perspective_named[material->perspective];
    s->span.map = map->texels;
    deep->takes = material_takes_vertices(material);
    deep->exact = material->edges == EDGES_EXACT;
    deep->saved = s->setting == PERSPECTIVE_EVERY16 ? PERSPECTIVE_SAVED_EVERY16 : PERSPECTIVE_SAVED_EVERY8;
    deep->right = perspective_has_pieces(s->setting) && s->renderer->reciprocals ? (uint32)s->frame->width << 16 : 0;
    return 1;
}

/* Sets both. */
static inline int32 deep_set(struct deep *deep, struct renderer *renderer, const struct material *material)
{
    return material->perspective && deep_begin(deep, renderer) && deep_take(deep, material);
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
        deep_set_vertices(deep, polygon);
        result = deep_draw(deep);
    }
    return result == DEEP_CONSTANT ? polygon_draw_inside(s->renderer, polygon, s->material)
                                   : (enum polygon_result)result;
}

enum polygon_result deep_run(struct deep *deep, struct renderer *renderer, const struct polygon *polygons,
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
