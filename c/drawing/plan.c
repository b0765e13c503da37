#include "drawing/plan.h"

#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "polygon/shading.h"

/* Sets the map, light and code of the plan. Returns POLYGON_WRONG_MAP if the mapper cannot draw
   this map or frame, else POLYGON_DRAWN. */
static enum polygon_result set_map(struct setup *s)
{
    struct column_layout *columns = &s->scratch->columns;
    const struct map *map = s->material->map;
    const enum mapper mapper = s->material->mapper;
    const struct mapper_traits *traits = &mappers[mapper];
    uint8 *code;

    if (!(s->frame->pixel_bytes & traits->bytes) || traits->is & MAPPER_UNIT)
        return POLYGON_WRONG_MAP;
    if (traits->layout == MAP_LAYOUTS)
        return POLYGON_DRAWN;
    if (!map || map->layout != traits->layout || map->texel_bytes != s->frame->pixel_bytes)
        return POLYGON_WRONG_MAP;
    s->span.map = map->texels;
    if (mapper == MAPPER_AFFINE)
        return POLYGON_DRAWN;
    code = plan_room(s)->code;
    s->span.map_width = map->width;
    s->span.map_height = map->height;
    s->span.columns = columns;
    s->span.code = code + ((0 - (uint32)code) & (CACHE_BYTES - 1));
    if (traits->is & MAPPER_LIGHTS
        && !shading_light(&s->span, s->material,
                          s->affine == SPAN_LIT_GOURAUD ? 0 : s->given->shade))
        return POLYGON_WRONG_MAP;
    if (mapper == MAPPER_COLUMNS && !column_layout_make(columns, map->width, map->height))
        return POLYGON_WRONG_MAP;
    return POLYGON_DRAWN;
}

/* Returns the pixel of a flat polygon. */
static uint32 colour(const struct setup *s)
{
    return s->material->mapper == MAPPER_FLAT ? s->material->colour
         : s->material->mapper == MAPPER_GOURAUD ? (uint32)s->given->shade >> 16
         : *s->span.light;
}

static enum polygon_result set_span(struct setup *s)
{
    const struct frame *frame = s->frame;
    enum polygon_result result;

    s->span.lines = s->edges.lines;
    s->span.count = s->box.bottom - s->box.top;
    s->span.row = frame->pixels + s->box.top * frame->pitch - EDGE_BIAS * frame->pixel_bytes;
    s->span.pitch = frame->pitch;
    result = set_map(s);
    if (result == POLYGON_DRAWN && plan_is_flat(s))
        s->span.colour = colour(s);
    return result;
}

enum chain plan_chain(const struct setup *s)
{
    const struct material *m = s->material;

    if (m->mapper == MAPPER_GOURAUD)
        return m->gradients == GRADIENTS_PLANE ? CHAIN_SHADES : CHAIN_NONE;
    if (m->mapper == MAPPER_LIT_GOURAUD)
        return s->kind == SPAN_LIT_GOURAUD ? CHAIN_NONE : CHAIN_WHOLE;
    if (m->mapper != MAPPER_AFFINE && m->mapper != MAPPER_LIT && m->mapper != MAPPER_KEYED
        && (m->mapper != MAPPER_GENERATED || s->kind == SPAN_GENERATED))
        return CHAIN_NONE;
    if (m->gradients != GRADIENTS_PLANE || m->start != START_SUBTEXEL)
        return CHAIN_ANYWHERE;
    return m->whole ? CHAIN_WHOLE : CHAIN_PLANE;
}

void plan_set_plane(struct setup *s)
{
    struct texturing *t = &s->texturing;
    enum chain chain = plan_chain(s);

    plan_set_cuts(t, s->material->mapper);
    if (s->material->whole) {
        texturing_plane(t, &s->sides, &s->box, chain);
        texturing_starts(t, s->edges.left, s->edges.lefts);
    } else {
        plane_find(s, (int32)chain);
    }
}

/* Finds the outline and, unless the polygon is flat or has no plane of u and v, the plane. */
static enum polygon_result set_outline(struct setup *s)
{
    const int32 has_plane = !plan_is_flat(s) && s->kind != SPAN_PERSPECTIVE
        && s->material->gradients == GRADIENTS_PLANE;
    enum polygon_result result;

    if (has_plane && !s->material->whole) {
        plan_set_cuts(&s->texturing, s->material->mapper);
        return outline_find(s, (int32)plan_chain(s));
    }
    result = outline_find(s, OUTLINE_ALONE);
    if (has_plane && result == POLYGON_DRAWN)
        plan_set_plane(s);
    return result;
}

enum polygon_result plan_set_up(struct setup *s)
{
    const struct material *material = s->material;
    enum polygon_result result;

    s->vertices = material_vertices(s->scratch->vertices, s->given, s->count, material);
    if (lower_asked(s))
        lower_by_vertices(s);
    result = set_outline(s);
    return result == POLYGON_DRAWN ? set_span(s) : result;
}
