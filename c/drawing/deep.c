#include "drawing/deep.h"

#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/lower.h"
#include "drawing/material.h"

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

int32 deep_set(struct deep *deep, struct renderer *renderer, const struct material *material)
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
    deep->exact = material->edges == EDGES_EXACT;
    deep->row = frame->pixels - EDGE_BIAS;
    deep->right = perspective_has_pieces(s->setting) && renderer->reciprocals ? (uint32)frame->width << 16 : 0;
    return 1;
}

enum polygon_result deep_polygon(struct deep *deep, const struct polygon *polygon)
{
    struct setup *s = &deep->s;
    int32 result;

    if (polygon->count != 3
        && (!is_polygon(polygon) || (polygon->planar != PLANAR_ALL
            && !polygon_is_planar(s->renderer, polygon, polygon->vertices, PLANAR_DEPTHS))))
        return polygon_draw_inside(s->renderer, polygon, s->material);
    s->given = polygon->vertices;
    s->count = polygon->count;
    s->vertices = material_vertices(s->scratch->vertices, s->given, s->count, s->material);
    result = deep_draw(deep);
    return result == DEEP_CONSTANT ? polygon_draw_inside(s->renderer, polygon, s->material)
                                   : (enum polygon_result)result;
}

enum polygon_result polygon_draw_deep(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material)
{
    struct deep deep;

    return deep_set(&deep, renderer, material) ? deep_polygon(&deep, polygon)
                                               : polygon_draw_inside(renderer, polygon, material);
}
